#include "engine/probe_plot.h"

#include "engine/gnuplot.h"
#include "engine/probe_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>

namespace engine {
namespace {

/// The visible colours up to a share of the plot's height, each at `scale` times its own wavelength; pale ones turn to
/// white where the eye sees less, others to black.
std::string colours(double scale, double height, bool pale) {
    constexpr double step = 5.0;
    std::string bars;
    for (double nm = first_visible_nm; nm < last_visible_nm; nm += step) {
        glm::vec3 colour = pure_colour(nm + 0.5 * step);
        if (pale) {
            colour = 1.0F - 0.5F * (std::max({colour.r, colour.g, colour.b}) - colour);
        }
        const glm::vec3 bytes = glm::round(255.0F * colour);
        bars += fmt::format("set object rectangle from first {:.6g}, graph 0 to first {:.6g}, graph {} behind "
                            "fillcolor rgb '#{:02x}{:02x}{:02x}' fillstyle solid noborder\n",
                            scale * nm, scale * (nm + step), height, static_cast<int>(bytes.r),
                            static_cast<int>(bytes.g), static_cast<int>(bytes.b));
    }
    return bars;
}

/// The ends of the visible.
std::string visible_ends() {
    std::string lines;
    for (const double nm : {first_visible_nm, last_visible_nm}) {
        lines +=
            fmt::format("set arrow from first {0}, graph 0 to first {0}, graph 1 nohead linecolor rgb '#bbbbbb'\n", nm);
    }
    return lines;
}

} // namespace

std::string probe_plot_script(const std::string& file, const render::ProbedLight& light) {
    constexpr int points = 200;
    std::string data;
    double most = 0.0;
    for (int i = 0; i <= points; ++i) {
        const double nm = 100.0 * std::pow(100.0, static_cast<double>(i) / points);
        const double emitted = light.emitted(nm);
        const double received = light.received(nm);
        most = std::max({most, emitted, received});
        data += fmt::format("{:.6g} {:.6g} {:.6g}\n", nm, emitted, received);
    }
    const RadianceAxis axis(most);
    const std::vector<std::string> lines = probe_lines(light);
    return fmt::format(
        "$spectrum << END\n{}END\n"
        "set terminal svg size 900,520 background '#ffffff' font 'sans,13'\nset output {}\n"
        "set logscale xy\nset xrange [99.99:10001]\nset yrange [1e{}:1e{}]\nset format y '10^{{%T}}'\n"
        "set xtics ('100 nm' 100, '300' 300, '1 um' 1000, '3' 3000, '10 um' 10000)\n"
        "set grid linecolor rgb '#bbbbbb'\nset key top right\n"
        "set title {} noenhanced\nset xlabel 'wavelength; along the foot: where what is seen was emitted'\n"
        "set ylabel {} noenhanced\n{}{}"
        "plot $spectrum using 1:2 with lines linewidth 2.5 linecolor rgb '#555555' title 'emitted', "
        "$spectrum using 1:3 with lines linewidth 2.5 linecolor rgb '#0072b2' title 'received'\n",
        data, gnuplot_text(file), axis.top_exponent - RadianceAxis::decades, axis.top_exponent,
        gnuplot_text(lines[0] + "; " + lines[1]), gnuplot_text(radiance_unit(light)),
        colours(1.0, 1.0, true) + visible_ends(), colours(1.0 / light.wavelength_ratio, 0.04, false));
}

} // namespace engine
