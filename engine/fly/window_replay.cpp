#include "engine/flight_file.h"
#include "engine/fly/window_flight.h"
#include "engine/replay.h"
#include "sim/bad_input.h"

#include <fmt/core.h>
#include <utility>

namespace engine {

void WindowFlight::begin_replay() {
    deck_.emplace(load_replay(options_.replay).recording);
    timeline_.emplace(*deck_);
    recorded_.emplace(RecordedFlight::replay(scenario_, options_.replay));
    recorded_->flight().show_world_line(std::make_shared<const sim::ShipWorldLine>(deck_->world_line()));
    recorded_->flight().show(deck_->moment());
}

void WindowFlight::play(double elapsed_seconds) {
    deck_->advance(elapsed_seconds);
    recorded_->flight().show(deck_->moment());
    fraction_ = deck_->moment().fraction;
}

void WindowFlight::handle_replay(input::Action action) {
    const double ten_seconds = 10.0 * scenario_.pace * deck_->moment().vehicle.tick_rate; // at the recorded pace
    switch (action) {
    case input::Action::pause:
        deck_->set_paused(!deck_->paused());
        break;
    case input::Action::single_tick:
        deck_->set_paused(true);
        deck_->step(1);
        break;
    case input::Action::single_tick_back:
        deck_->set_paused(true);
        deck_->step(-1);
        break;
    case input::Action::slower:
        deck_->slower();
        break;
    case input::Action::faster:
        deck_->faster();
        break;
    case input::Action::play_backwards:
        deck_->reverse();
        deck_->set_paused(false);
        break;
    case input::Action::ten_seconds_back:
        deck_->seek(deck_->position() - ten_seconds);
        break;
    case input::Action::ten_seconds_ahead:
        deck_->seek(deck_->position() + ten_seconds);
        break;
    case input::Action::previous_mark:
        deck_->seek_mark(false);
        break;
    case input::Action::next_mark:
        deck_->seek_mark(true);
        break;
    case input::Action::reset:
        deck_->seek(static_cast<double>(deck_->first()));
        notices_.show("the recording from its start");
        break;
    case input::Action::bookmark:
        keep_mark();
        break;
    case input::Action::take_over:
        take_over();
        break;
    default:
        break;
    }
}

void WindowFlight::keep_mark() {
    const Bookmark bookmark = deck_->mark();
    try {
        const std::filesystem::path file = keep_bookmark(options_.replay, bookmark);
        notices_.show(fmt::format("{}, kept in {}", bookmark.what, file.filename().string()));
    } catch (const sim::BadInput& error) {
        notices_.show(fmt::format("{}, for this replay only: {}", bookmark.what, error.what()), 8.0);
    }
}

void WindowFlight::take_over() {
    const FlightChange start = deck_->branch();
    const std::string origin = deck_->branch_origin();
    // The ship comes from somewhere: whoever sees it late sees it there.
    sim::ShipWorldLine flown = deck_->world_line_until_now();
    recorded_.emplace(scenario_, new_flight_file(scenario_.name), start, origin);
    recorded_->flight().keep_world_line(std::move(flown));
    deck_.reset();
    timeline_.reset();
    options_.replay.clear(); // a new flight from the start is one by hand
    hands_.set_vehicle(start.vehicle);
    hands_.set_metres_per_light_unit(start.metres_per_light_unit);
    hands_.set_seconds_per_tick(1.0 / (clock_.pace() * start.vehicle.tick_rate));
    fraction_ = 0.0;
    bookmarks_ = 0;
    fmt::print("{}\n", origin);
    notices_.show("you fly", 4.0);
}

void WindowFlight::draw_timeline() {
    if (const std::optional<double> wanted = timeline_->draw(imgui_, *deck_, scenario_.clock_unit_name)) {
        deck_->seek(*wanted);
        recorded_->flight().show(deck_->moment());
        fraction_ = deck_->moment().fraction;
    }
}

} // namespace engine
