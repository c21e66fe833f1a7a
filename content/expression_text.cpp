#include "content/expression_text.h"

#include "content/nearest_name.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>
#include <vector>

namespace content {
namespace {

using sim::Instruction;
using sim::Operation;

constexpr std::array<std::string_view, 4> coordinates{"t", "x", "y", "z"};
constexpr std::array<std::pair<std::string_view, Operation>, 7> functions{{{"sqrt", Operation::square_root},
                                                                           {"exp", Operation::exponential},
                                                                           {"log", Operation::logarithm},
                                                                           {"sin", Operation::sine},
                                                                           {"cos", Operation::cosine},
                                                                           {"tanh", Operation::hyperbolic_tangent},
                                                                           {"atan", Operation::arc_tangent}}};
constexpr int deepest_definition = 30;
constexpr double largest_power = 64.0;

/// Recursive descent; every rule appends its instructions in postfix order.
class Parser {
  public:
    Parser(const std::string& source, std::string field, const std::string& text, const ExpressionNames& names,
           std::vector<Instruction>& program, int depth)
        : source_(source), field_(std::move(field)), text_(text), names_(names), program_(program), depth_(depth) {}

    void parse() {
        sum();
        if (at_ < text_.size()) {
            fail(fmt::format("\"{}\" is not expected here", text_.substr(at_)));
        }
    }

  private:
    [[noreturn]] void fail(const std::string& reason) const { throw sim::BadInput(source_, field_, text_, reason); }

    char next() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
            ++at_;
        }
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char symbol) {
        if (next() != symbol) {
            return false;
        }
        ++at_;
        return true;
    }
    void emit(Operation operation, double number = 0.0, int index = 0) {
        program_.push_back({operation, number, index});
    }

    void sum() {
        product();
        while (next() == '+' || next() == '-') {
            const bool plus = text_[at_++] == '+';
            product();
            emit(plus ? Operation::add : Operation::subtract);
        }
    }
    void product() {
        signed_factor();
        while (next() == '*' || next() == '/') {
            const bool times = text_[at_++] == '*';
            signed_factor();
            emit(times ? Operation::multiply : Operation::divide);
        }
    }
    void signed_factor() {
        if (take('-')) {
            signed_factor();
            emit(Operation::negate);
        } else {
            take('+');
            power();
        }
    }
    void power() {
        atom();
        if (take('^')) {
            const bool negative = take('-');
            const double exponent = std::isdigit(static_cast<unsigned char>(next())) != 0 ? number() : std::nan("");
            if (!(exponent == std::floor(exponent) && exponent <= largest_power)) {
                fail(fmt::format("^ takes a whole number up to {}; for others there are sqrt, exp and log",
                                 largest_power));
            }
            emit(Operation::power, 0.0, static_cast<int>(negative ? -exponent : exponent));
        }
    }
    double number() {
        double value = 0.0;
        const char* begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (error != std::errc()) {
            fail("a number cannot be read");
        }
        at_ += static_cast<std::size_t>(end - begin);
        return value;
    }
    void atom() {
        const char first = next();
        if (take('(')) {
            if (++parentheses_ > deepest_definition) {
                fail("nested too deeply");
            }
            sum();
            close();
            --parentheses_;
        } else if (std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '.') {
            emit(Operation::number, number());
        } else if (std::isalpha(static_cast<unsigned char>(first)) != 0 || first == '_') {
            name();
        } else {
            fail(first == '\0' ? "the formula breaks off"
                               : fmt::format("\"{}\" is not expected here", text_.substr(at_)));
        }
    }
    void close() {
        if (!take(')')) {
            fail("a ) is missing");
        }
    }
    void name() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_')) {
            ++at_;
        }
        const std::string word = text_.substr(begin, at_ - begin);
        const auto function = std::ranges::find(functions, word, &std::pair<std::string_view, Operation>::first);
        if (function != functions.end()) {
            if (!take('(')) {
                fail(fmt::format("{} needs its argument in parentheses", word));
            }
            sum();
            close();
            emit(function->second);
        } else if (const auto axis = std::ranges::find(coordinates, word); axis != coordinates.end()) {
            emit(Operation::coordinate, 0.0, static_cast<int>(axis - coordinates.begin()));
        } else if (const auto value = names_.numbers.find(word); value != names_.numbers.end()) {
            emit(Operation::number, value->second);
        } else if (const auto formula = names_.definitions.find(word); formula != names_.definitions.end()) {
            if (depth_ >= deepest_definition) {
                fail(fmt::format("the definition of {} needs itself", word));
            }
            Parser(source_, "definitions." + word, formula->second, names_, program_, depth_ + 1).parse();
        } else if (word == "pi") {
            emit(Operation::number, std::numbers::pi);
        } else {
            fail(fmt::format("{} is not known; did you mean {}?", word, nearest_name(word, known_names())));
        }
    }
    std::vector<std::string> known_names() const {
        std::vector<std::string> known(coordinates.begin(), coordinates.end());
        known.emplace_back("pi");
        for (const auto& [text, operation] : functions) {
            known.emplace_back(text);
        }
        for (const auto& [text, value] : names_.numbers) {
            known.push_back(text);
        }
        for (const auto& [text, formula] : names_.definitions) {
            known.push_back(text);
        }
        return known;
    }

    const std::string& source_;
    const std::string field_;
    const std::string& text_;
    const ExpressionNames& names_;
    std::vector<Instruction>& program_;
    int depth_;
    int parentheses_ = 0;
    std::size_t at_ = 0;
};

} // namespace

sim::Expression parse_expression(const std::string& source, const std::string& field, const std::string& text,
                                 const ExpressionNames& names) {
    std::vector<Instruction> program;
    Parser(source, field, text, names, program, 0).parse();
    try {
        return sim::Expression(std::move(program));
    } catch (const std::invalid_argument& error) {
        throw sim::BadInput(source, field, text, error.what());
    }
}

} // namespace content
