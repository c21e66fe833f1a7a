#include "sim/spacetime/expression.h"

#include <utility>

namespace sim {

Expression::Expression(std::vector<Instruction> program) : program_(std::move(program)) {
    std::size_t depth = 0;
    for (const Instruction& each : program_) {
        const bool pushes = each.operation == Operation::number || each.operation == Operation::coordinate;
        const bool two = each.operation == Operation::add || each.operation == Operation::subtract ||
                         each.operation == Operation::multiply || each.operation == Operation::divide;
        if (!pushes && depth < (two ? 2U : 1U)) {
            throw std::invalid_argument("an operator lacks its operands");
        }
        depth = pushes ? depth + 1 : two ? depth - 1 : depth;
        if (depth > deepest) {
            throw std::invalid_argument("nested too deeply");
        }
    }
    if (depth != 1) {
        throw std::invalid_argument("not one value");
    }
}

} // namespace sim
