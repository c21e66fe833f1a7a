#pragma once

namespace engine {

/// While one of these lives, Ctrl-C and a polite kill only raise a flag, so that what is under way can be finished; a
/// second Ctrl-C ends the program at once.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    static bool wanted();
};

} // namespace engine
