#pragma once

#include "sim/spacetime/dual.h"

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

/// Expressions over t, x, y, z that somebody else wrote, evaluated in any number type: dual numbers differentiate them.
namespace sim {

enum class Operation : std::uint8_t {
    number,
    coordinate,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power, ///< to a whole number
    square_root,
    exponential,
    logarithm,
    sine,
    cosine,
    hyperbolic_tangent,
    arc_tangent,
};

/// One instruction in postfix order.
struct Instruction {
    Operation operation = Operation::number;
    double number = 0.0; ///< of `number`
    int index = 0;       ///< of `coordinate`: 0 to 3; of `power`: the exponent
};

/// A formula as instructions for a stack.
class Expression {
  public:
    static constexpr std::size_t deepest = 24; ///< values that may wait on the stack

    /// A constant.
    Expression(double value) : program_{{Operation::number, value, 0}} {} // NOLINT(google-explicit-constructor)

    /// Throws std::invalid_argument for a program that does not leave one value, or goes deeper than `deepest`.
    explicit Expression(std::vector<Instruction> program);

    bool depends_on(int coordinate) const {
        for (const Instruction& each : program_) {
            if (each.operation == Operation::coordinate && each.index == coordinate) {
                return true;
            }
        }
        return false;
    }

    template <class T>
    T at(const std::array<T, 4>& coordinates) const {
        using std::atan, std::cos, std::exp, std::log, std::sin, std::sqrt, std::tanh;
        std::array<T, deepest> stack{};
        std::size_t top = 0; // values on the stack
        for (const Instruction& each : program_) {
            T& last = stack[top == 0 ? 0 : top - 1];
            switch (each.operation) {
            case Operation::number:
                stack[top++] = T(each.number);
                break;
            case Operation::coordinate:
                stack[top++] = coordinates[static_cast<std::size_t>(each.index)];
                break;
            case Operation::negate:
                last = -last;
                break;
            case Operation::add:
                --top;
                stack[top - 1] = stack[top - 1] + stack[top];
                break;
            case Operation::subtract:
                --top;
                stack[top - 1] = stack[top - 1] - stack[top];
                break;
            case Operation::multiply:
                --top;
                stack[top - 1] = stack[top - 1] * stack[top];
                break;
            case Operation::divide:
                --top;
                stack[top - 1] = stack[top - 1] / stack[top];
                break;
            case Operation::power:
                last = whole_power(last, each.index);
                break;
            case Operation::square_root:
                last = sqrt(last);
                break;
            case Operation::exponential:
                last = exp(last);
                break;
            case Operation::logarithm:
                last = log(last);
                break;
            case Operation::sine:
                last = sin(last);
                break;
            case Operation::cosine:
                last = cos(last);
                break;
            case Operation::hyperbolic_tangent:
                last = tanh(last);
                break;
            case Operation::arc_tangent:
                last = atan(last);
                break;
            }
        }
        return stack[0];
    }

  private:
    template <class T>
    static T whole_power(const T& base, int exponent) {
        T result(1.0);
        for (int i = 0; i < (exponent < 0 ? -exponent : exponent); ++i) {
            result = result * base;
        }
        return exponent < 0 ? T(1.0) / result : result;
    }

    std::vector<Instruction> program_;
};

} // namespace sim
