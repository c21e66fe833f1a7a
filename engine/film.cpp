#include "engine/film.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

// POSIX leaves the declaration of the environment to the program.
extern char** environ; // NOLINT(readability-redundant-declaration)

namespace engine {
namespace {

/// Starts a program with `input` as its standard input and its messages thrown away; returns 0 or an errno.
int spawn_quietly(const std::filesystem::path& program, std::vector<std::string> arguments, int input, int& process) {
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    const int result = posix_spawn(&process, program.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return result;
}

/// Waits for a program's end; 0 when all went well.
int wait_for(int process) {
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

} // namespace

std::filesystem::path program_on_path(const std::string& name) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::filesystem::path candidate = std::filesystem::path(folder) / name;
        if (access(candidate.c_str(), X_OK) == 0) {
            return candidate;
        }
    }
    return {};
}

std::string encode_frames(const std::filesystem::path& pattern, double frames_per_second,
                          const std::string& description, const std::filesystem::path& film) {
    const std::filesystem::path ffmpeg = program_on_path("ffmpeg");
    if (ffmpeg.empty()) {
        return "no film: ffmpeg is not installed (Debian: apt-get install ffmpeg)";
    }
    std::filesystem::path unfinished = film;
    unfinished.replace_extension(".unfinished" + film.extension().string());
    std::vector<std::string> arguments{"ffmpeg",
                                       "-y",
                                       "-loglevel",
                                       "error",
                                       "-framerate",
                                       fmt::format("{}", frames_per_second),
                                       "-i",
                                       pattern.string(),
                                       "-map_metadata",
                                       "-1",
                                       "-metadata",
                                       "comment=" + description,
                                       "-fflags",
                                       "+bitexact",
                                       "-flags:v",
                                       "+bitexact",
                                       "-threads",
                                       "1",
                                       "-vf",
                                       "scale=out_color_matrix=bt709:out_range=tv",
                                       "-pix_fmt",
                                       "yuv420p",
                                       "-colorspace",
                                       "bt709",
                                       "-color_range",
                                       "tv"};
    const std::vector<std::string> codec =
        film.extension() == ".webm"
            ? std::vector<std::string>{"-c:v", "libvpx-vp9", "-b:v", "0", "-crf", "20", "-row-mt", "0"}
            : std::vector<std::string>{"-c:v", "libx264", "-preset", "medium", "-crf", "16", "-movflags", "+faststart"};
    arguments.insert(arguments.end(), codec.begin(), codec.end());
    arguments.push_back(std::filesystem::absolute(unfinished).string());
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    int process = -1;
    const int result = spawn_quietly(ffmpeg, std::move(arguments), nothing, process);
    close(nothing);
    if (result != 0) {
        return fmt::format("no film: {}: {}", ffmpeg.string(), std::strerror(result));
    }
    std::error_code error;
    if (wait_for(process) != 0) {
        std::filesystem::remove(unfinished, error);
        return fmt::format("{}: ffmpeg could not write the film", film.string());
    }
    std::filesystem::rename(unfinished, film, error);
    return error ? fmt::format("{}: {}", film.string(), error.message()) : "";
}

Film::Film(std::filesystem::path file, int width, int height, double frames_per_second) : file_(std::move(file)) {
    start(width, height, frames_per_second);
}

void Film::start(int width, int height, double frames_per_second) {
    const std::filesystem::path ffmpeg = program_on_path("ffmpeg");
    if (ffmpeg.empty()) {
        trouble_ = "no film: ffmpeg is not installed (Debian: apt-get install ffmpeg)";
        return;
    }
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        trouble_ = fmt::format("no film: {}", std::strerror(errno));
        return;
    }
    // A film player wants even sides; the filter repeats no pixel of an even picture.
    const int result = spawn_quietly(ffmpeg,
                                     {"ffmpeg",
                                      "-y",
                                      "-loglevel",
                                      "error",
                                      "-f",
                                      "rawvideo",
                                      "-pix_fmt",
                                      "rgba",
                                      "-s",
                                      fmt::format("{}x{}", width, height),
                                      "-r",
                                      fmt::format("{}", frames_per_second),
                                      "-i",
                                      "-",
                                      "-vf",
                                      "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                      "-c:v",
                                      "libx264",
                                      "-preset",
                                      "veryfast",
                                      "-crf",
                                      "18",
                                      "-pix_fmt",
                                      "yuv420p",
                                      "-colorspace",
                                      "bt709",
                                      "-movflags",
                                      "+faststart",
                                      std::filesystem::absolute(file_).string()},
                                     ends[0], process_);
    close(ends[0]);
    pipe_ = ends[1];
    if (result != 0) {
        process_ = -1;
        trouble_ = fmt::format("no film: {}: {}", ffmpeg.string(), std::strerror(result));
    }
}

Film::~Film() {
    finish();
    if (pipe_ >= 0) {
        close(pipe_);
    }
}

void Film::add(const content::Image& picture) {
    if (process_ < 0 || pipe_ < 0 || !trouble_.empty()) {
        return;
    }
    // ffmpeg may end early (a full disk): that is a trouble to tell, not a signal to die of.
    auto* const handler_before = std::signal(SIGPIPE, SIG_IGN);
    std::size_t written = 0;
    while (written < picture.rgba.size()) {
        const ssize_t count = write(pipe_, picture.rgba.data() + written, picture.rgba.size() - written);
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count <= 0) {
            trouble_ = fmt::format("{}: the film stopped: ffmpeg could not write it", file_.string());
            break;
        }
        written += static_cast<std::size_t>(count);
    }
    std::signal(SIGPIPE, handler_before);
}

bool Film::finish() {
    if (process_ < 0) {
        return false;
    }
    close(std::exchange(pipe_, -1));
    const int status = wait_for(std::exchange(process_, -1));
    if (status != 0 && trouble_.empty()) {
        trouble_ = fmt::format("{}: ffmpeg could not write the film", file_.string());
    }
    return trouble_.empty();
}

} // namespace engine
