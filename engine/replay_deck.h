#pragma once

#include "engine/flight.h"
#include "engine/recording_file.h"
#include "sim/ship_world_line.h"

#include <cstdint>
#include <string>
#include <vector>

namespace engine {

/// A moment worth going back to.
struct ReplayMark {
    sim::Tick tick = 0;
    std::string what; ///< one line
};

/// Plays a recorded flight at any pace, forwards and backwards, from any moment: flown again from the snapshot before
/// it, at most snapshot_interval ticks. A recording whose physics was another is led back to its own states at each
/// snapshot. Knows no clock and no window.
class ReplayDeck {
  public:
    /// Stands at the start, at the recorded pace. The recording must be sound.
    explicit ReplayDeck(Recording recording);

    const Recording& recording() const { return recording_; }
    sim::Tick first() const { return recording_.first_tick(); }
    sim::Tick end() const { return recording_.end(); }

    /// In ticks, with the part of the next that has passed; from first() to end().
    double position() const { return position_; }
    /// Goes to a position; beyond the ends to the end.
    void seek(double position);
    /// Goes whole ticks on (back, if negative), from the tick that it stands at or has passed last.
    void step(std::int64_t ticks);
    /// Lets seconds of the viewer's time pass, >= 0. At an end of the flight it stops and is paused.
    void advance(double seconds);

    bool paused() const { return paused_; }
    void set_paused(bool paused) { paused_ = paused; }
    bool backwards() const { return backwards_; }
    void reverse() { backwards_ = !backwards_; }
    /// Factor on the scenario's pace: 1/100 to 1000 in steps of 1, 2, 5.
    double speed() const;
    void faster();
    void slower();

    /// The flight at its position.
    const FlightMoment& moment() const { return moment_; }
    /// The ship just there.
    sim::VehicleState state() const { return moment_.between(); }

    /// The whole flight as a world line, flown again once.
    sim::ShipWorldLine world_line() const { return world_line_to(end()); }
    /// Up to the last whole tick.
    sim::ShipWorldLine world_line_until_now() const { return world_line_to(state_.tick); }

    /// Start, changes, bookmarks, events and end, by rising tick.
    const std::vector<ReplayMark>& marks() const { return marks_; }
    /// Marks the last whole tick, under the next number; to be kept by keep_bookmark.
    Bookmark mark();
    /// To the next mark, or the one before; stays where there is none.
    void seek_mark(bool next);

    /// A flight that goes on from the last whole tick under other hands.
    FlightChange branch() const;
    /// Where that flight comes from, for RecordingHeader::origin.
    std::string branch_origin() const;

  private:
    sim::ShipWorldLine world_line_to(sim::Tick tick) const;
    void fly_to(sim::Tick tick);
    void start_from_anchor(sim::Tick tick);
    void make_change(std::size_t index);
    void fly_one();
    /// The state after one more tick, without changes.
    sim::VehicleState next_state() const;
    void show();

    Recording recording_;
    double position_ = 0.0;
    bool paused_ = false;
    bool backwards_ = false;
    std::size_t speed_ = 0; ///< in the table of speeds
    std::vector<ReplayMark> marks_;

    // The flight at the last whole tick, its changes made.
    sim::VehicleState state_;
    std::size_t change_ = 0; ///< the last that was made
    FlightMoment moment_;
};

/// The demand that holds at a tick.
sim::ControlFrame demand_at(const Recording& recording, sim::Tick tick);

} // namespace engine
