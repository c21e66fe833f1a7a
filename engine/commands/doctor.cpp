#include "engine/commands/commands.h"

#include "content/scenario.h"
#include "engine/film.h"
#include "engine/gnuplot.h"
#include "engine/hud/imgui_layer.h"
#include "engine/openxr_runtime.h"
#include "engine/window.h"
#include "render/gl/egl_context.h"
#include "render/gl/software_opengl.h"
#include "sim/bad_input.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <fmt/core.h>
#include <fmt/format.h>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace engine {
namespace {

void print_line(const std::string& what, const std::string& finding) {
    fmt::print("{:<10} {}\n", what, finding);
}

std::string gl_text(GLenum name) {
    const GLubyte* const text = glGetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "?";
}

std::string gl_description() {
    return fmt::format("OpenGL {}, {}, {}", gl_text(GL_VERSION), gl_text(GL_RENDERER), gl_text(GL_VENDOR));
}

std::string egl_text(EGLDisplay display, EGLint name) {
    const char* const text = eglQueryString(display, name);
    return text != nullptr ? text : "?";
}

/// Without a display: what headless flights and `render` use.
void examine_egl(std::set<std::string>& packages) {
    try {
        const render::EglContext context;
        EGLDisplay display = eglGetCurrentDisplay();
        print_line("EGL", fmt::format("{}, {}", egl_text(display, EGL_VERSION), egl_text(display, EGL_VENDOR)));
        print_line("headless", gl_description());
        print_line("pictures", render::software_opengl()
                                   ? "by method ray: OpenGL is drawn by the processor here, and rays are faster"
                                   : "by method texture: OpenGL runs on graphics hardware");
    } catch (const sim::BadInput& error) {
        print_line("EGL", error.what());
        print_line("pictures", "stills by method ray, which needs no OpenGL; no flights");
        packages.insert({"libegl1", "libegl-mesa0", "libgl1-mesa-dri"});
    }
}

void examine_window() {
    try {
        const Window window("Rapidity doctor", 64, 64, Window::Visible::no);
        print_line("window", fmt::format("{}, text at {:g} of its size", gl_description(), window.content_scale()));
    } catch (const NoDisplay& error) {
        print_line("window", fmt::format("none ({}): `fly` flies headless", error.what()));
    } catch (const sim::BadInput& error) {
        print_line("window", error.what());
    }
}

void examine_gamepads() {
    const std::vector<std::string> names = gamepad_names();
    print_line("gamepads", names.empty() ? "none plugged in" : fmt::format("{}", fmt::join(names, "; ")));
}

void examine_openxr() {
    const OpenXrRuntime runtime = find_openxr_runtime();
    print_line("OpenXR",
               fmt::format("loader: {}; runtime: {}",
                           runtime.loader.empty() ? "none (optional: libopenxr-loader1)" : runtime.loader.string(),
                           runtime.manifest.empty() ? "none (no active_runtime.json)" : runtime.manifest.string()));
}

void examine_programs_and_fonts(std::set<std::string>& packages) {
    const std::filesystem::path ffmpeg = program_on_path("ffmpeg");
    print_line("plots", has_gnuplot() ? "gnuplot" : "no gnuplot: bench prints tables only");
    if (!has_gnuplot()) {
        packages.insert("gnuplot-nox");
    }
    print_line("film", ffmpeg.empty() ? "no ffmpeg: headless flights leave stills only" : ffmpeg.string());
    if (ffmpeg.empty()) {
        packages.insert("ffmpeg");
    }
    const bool font = std::filesystem::exists(instrument_font());
    print_line("font", font ? instrument_font().string() : "none with Greek letters: the instruments say words");
    if (!font) {
        packages.insert("fonts-dejavu-core");
    }
}

void examine_content() {
    try {
        std::vector<std::string> names;
        std::set<std::string> missing;
        for (const content::Scenario& scenario : content::built_in_scenarios()) {
            names.push_back(scenario.name);
            for (const std::string& line : content::missing_content(scenario)) {
                missing.insert(line);
            }
        }
        print_line("scenarios", fmt::format("{}", fmt::join(names, ", ")));
        if (missing.empty()) {
            missing.insert("everything that they use is here");
        }
        std::string label = "content";
        for (const std::string& line : missing) {
            print_line(std::exchange(label, ""), line);
        }
    } catch (const sim::BadInput& error) {
        print_line("scenarios", error.what());
    }
}

void examine_machine() {
    std::set<std::string> packages;
    print_line("rapidity", RAPIDITY_VERSION);
    examine_egl(packages);
    examine_window();
    examine_gamepads();
    examine_openxr();
    examine_programs_and_fonts(packages);
    examine_content();
    if (packages.empty()) {
        print_line("missing", "nothing");
    } else {
        print_line("missing", fmt::format("apt-get install {}", fmt::join(packages, " ")));
    }
}

} // namespace

void add_doctor_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("doctor", "print what this machine offers, and what is missing");
    command->group("About");
    command->callback(examine_machine);
}

} // namespace engine
