#pragma once

#include "engine/application.h"

#include <string>
#include <vector>

namespace tests {

/// The program's exit code for these words after its name.
inline int rapidity(std::vector<std::string> words) {
    words.insert(words.begin(), "rapidity");
    std::vector<const char*> arguments;
    arguments.reserve(words.size());
    for (const std::string& word : words) {
        arguments.push_back(word.c_str());
    }
    return engine::run_application(static_cast<int>(arguments.size()), arguments.data());
}

} // namespace tests
