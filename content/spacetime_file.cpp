#include "content/spacetime_file.h"

#include "content/expression_text.h"
#include "content/nearest_name.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <sstream>
#include <toml++/toml.h>

namespace content {
namespace {

constexpr std::array<std::string_view, 10> component_names{"tt", "tx", "ty", "tz", "xx", "xy", "xz", "yy", "yz", "zz"};

class SpacetimeReader {
  public:
    explicit SpacetimeReader(std::string source) : source_(std::move(source)) {}

    sim::CustomSpacetime read(const toml::table& root, const sim::ParameterValues& given) {
        known(root, "", {"name", "smallest_length", "flat_radius", "parameters", "definitions", "metric"});
        sim::CustomSpacetime spacetime;
        spacetime.name = root["name"].value_or(source_);
        spacetime.smallest_length = positive(root, "smallest_length", spacetime.smallest_length);
        spacetime.flat_radius = positive(root, "flat_radius", spacetime.flat_radius);
        ExpressionNames names;
        for (const auto& [key, node] : table(root, "parameters")) {
            const auto value = node.value<double>();
            if (!value || !std::isfinite(*value)) {
                fail("parameters." + std::string(key.str()), text_of(node), "must be a finite number");
            }
            names.numbers.emplace(key.str(), *value);
        }
        for (const auto& [name, value] : given) {
            const auto parameter = names.numbers.find(name);
            if (parameter == names.numbers.end()) {
                fail(name, "", "not a parameter of this spacetime");
            }
            parameter->second = value;
        }
        for (const auto& [key, node] : table(root, "definitions")) {
            names.definitions.emplace(key.str(), formula("definitions." + std::string(key.str()), node));
        }
        read_metric(table(root, "metric"), names, spacetime);
        check_far_away(spacetime);
        return spacetime;
    }

  private:
    [[noreturn]] void fail(const std::string& field, const std::string& value, const std::string& reason) const {
        throw sim::BadInput(source_, field, value, reason);
    }
    static std::string text_of(const toml::node& node) {
        if (node.is_table() || node.is_array()) {
            return {}; // of many lines, perhaps
        }
        std::ostringstream text;
        node.visit([&](const auto& value) { text << value; });
        return text.str();
    }
    void known(const toml::table& table, const std::string& prefix, const std::vector<std::string>& names) const {
        for (const auto& [key, node] : table) {
            if (std::ranges::find(names, key.str()) == names.end()) {
                fail(prefix + std::string(key.str()), text_of(node),
                     fmt::format("this key is not known; did you mean {}?", nearest_name(key.str(), names)));
            }
        }
    }
    toml::table table(const toml::table& root, const std::string& name) const {
        const toml::node* node = root.get(name);
        if (node == nullptr) {
            return {};
        }
        if (!node->is_table()) {
            fail(name, text_of(*node), "must be a table");
        }
        return *node->as_table();
    }
    double positive(const toml::table& root, const std::string& name, double standard) const {
        const toml::node* node = root.get(name);
        if (node == nullptr) {
            return standard;
        }
        const auto value = node->value<double>();
        if (!value || !(*value > 0.0 && *value < 1e12)) {
            fail(name, text_of(*node), "must be a positive length");
        }
        return *value;
    }
    std::string formula(const std::string& field, const toml::node& node) const {
        if (node.is_number()) {
            return fmt::format("{:.17g}", *node.value<double>());
        }
        if (!node.is_string()) {
            fail(field, text_of(node), "must be a formula in quotes");
        }
        return node.as_string()->get();
    }
    void read_metric(const toml::table& metric, const ExpressionNames& names, sim::CustomSpacetime& spacetime) const {
        known(metric, "metric.", {component_names.begin(), component_names.end()});
        for (const std::string_view name : component_names) {
            const std::string field = fmt::format("metric.{}", name);
            if (const toml::node* node = metric.get(name)) {
                spacetime.components.push_back(parse_expression(source_, field, formula(field, *node), names));
            } else if (name[0] == name[1]) {
                fail(field, "", "missing");
            } else {
                spacetime.components.emplace_back(0.0);
            }
        }
    }
    /// Where the file says that it is flat, along each axis, at some moments.
    void check_far_away(const sim::CustomSpacetime& spacetime) const {
        for (const double sign : {-1.0, 1.0}) {
            for (int axis = 1; axis < 4; ++axis) {
                sim::Components<double> far{0.3, 0.1, 0.2, 0.3};
                far[axis] = sign * spacetime.flat_radius;
                if (spacetime.region(far) != sim::Region::outside) {
                    fail("metric", "",
                         fmt::format("the signature is not (-,+,+,+) at flat_radius = {:g}", spacetime.flat_radius));
                }
                const auto g = spacetime.metric(far);
                for (int mu = 0; mu < 4; ++mu) {
                    for (int nu = mu; nu < 4; ++nu) {
                        const double flat = mu != nu ? 0.0 : mu == 0 ? -1.0 : 1.0;
                        const std::size_t index = sim::SymmetricTensor<double>::index(mu, nu);
                        if (!(std::abs(g(mu, nu) - flat) < 1e-2)) {
                            fail(fmt::format("metric.{}", component_names[index]), fmt::format("{:g}", g(mu, nu)),
                                 fmt::format("must be {:g} at flat_radius = {:g}", flat, spacetime.flat_radius));
                        }
                    }
                }
            }
        }
    }

    std::string source_;
};

} // namespace

sim::CustomSpacetime read_spacetime(const std::filesystem::path& file, const sim::ParameterValues& given) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        throw sim::BadInput(file.string(), "", "", "there is no such file");
    }
    try {
        return SpacetimeReader(file.string()).read(toml::parse_file(file.string()), given);
    } catch (const toml::parse_error& wrong) {
        throw sim::BadInput(file.string(), fmt::format("line {}", wrong.source().begin.line), "",
                            std::string(wrong.description()));
    }
}

sim::AnySpacetime spacetime_of(const std::string& source, const std::string& name_or_file,
                               const sim::ParameterValues& given) {
    if (name_or_file.ends_with(".toml")) {
        return read_spacetime(name_or_file, given);
    }
    return sim::make_spacetime(source, name_or_file, given);
}

} // namespace content
