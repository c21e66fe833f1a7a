#pragma once

#include <map>
#include <string>
#include <vector>

/// The program itself, run in a process of its own.
namespace tests {

struct Run {
    int exit_code = -1;
    std::string output; ///< standard output and error
};

/// `words` after `rapidity`; `environment` on top of this process'. `through`: a script that is given the whole
/// command.
Run run_program(const std::vector<std::string>& words, const std::map<std::string, std::string>& environment = {},
                const std::string& through = "");

} // namespace tests
