#include "sim/arithmetic.h"

#include <cstdio>
#include <cstring>

/// Built with flags that sim must not be built with. Succeeds when sim's check finds the trouble that the first
/// argument names; 77, skipped, on a processor without the instruction that the trouble needs.
int main(int argc, char** argv) {
    if (argc != 2) {
        return 2;
    }
#if defined(__FMA__)
    if (__builtin_cpu_supports("fma") == 0) {
        std::puts("this processor has no fused multiply-add");
        return 77;
    }
#endif
    const std::string_view trouble = sim::arithmetic_trouble();
    std::printf("found: %s\n", trouble.data());
    return trouble.find(argv[1]) != std::string_view::npos ? 0 : 1;
}
