#include "engine/older_demands.h"

#include "engine/recording_format.h"

#include <algorithm>
#include <limits>
#include <string>

namespace engine {
namespace {

constexpr sim::Tick no_tick = std::numeric_limits<sim::Tick>::max();

/// The rows of one table.
class DemandRows {
  public:
    DemandRows(Database& database, const std::string& table)
        : rows_(database.prepare("SELECT * FROM " + table + " ORDER BY tick")) {
        next();
    }
    /// Of the present row; no_tick when there is none.
    sim::Tick tick() const { return tick_; }
    const Statement& row() const { return rows_; }
    void next() { tick_ = rows_.step() ? read_tick(rows_, 0) : no_tick; }

  private:
    Statement rows_;
    sim::Tick tick_ = 0;
};

/// The part of numbers_of() that one table keeps.
struct Group {
    DemandRows rows;
    std::size_t first; ///< in numbers_of()
    std::size_t count;
};

} // namespace

std::vector<input::TimedControl> read_older_demands(Database& database) {
    std::vector<Group> groups;
    groups.push_back({DemandRows(database, "thrust"), 0, 3});
    groups.push_back({DemandRows(database, "turn"), 3, 3});
    groups.push_back({DemandRows(database, "head"), 6, 7});
    // From version 4 on the head has a velocity.
    groups.back().count = static_cast<std::size_t>(groups.back().rows.row().column_count()) - 1;
    DemandRows buttons(database, "buttons");

    std::vector<input::TimedControl> demands;
    auto numbers = numbers_of(sim::ControlFrame());
    std::uint32_t held = 0;
    while (true) {
        sim::Tick tick = buttons.tick();
        for (const Group& group : groups) {
            tick = std::min(tick, group.rows.tick());
        }
        if (tick == no_tick) {
            return demands;
        }
        for (Group& group : groups) {
            if (group.rows.tick() == tick) {
                for (std::size_t i = 0; i < group.count; ++i) {
                    numbers.at(group.first + i) = group.rows.row().exact(static_cast<int>(i) + 1);
                }
                group.rows.next();
            }
        }
        if (buttons.tick() == tick) {
            held = static_cast<std::uint32_t>(buttons.row().integer(1));
            buttons.next();
        }
        demands.push_back({tick, control_of(numbers, held)});
    }
}

} // namespace engine
