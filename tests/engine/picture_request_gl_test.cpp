#include "engine/picture_maker.h"
#include "engine/picture_request.h"
#include "sim/bad_input.h"
#include "tests/engine/command.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

TEST_CASE("the method is automatic unless it is asked for, and then settles on one") {
    engine::PictureOptions options;
    options.scenario = "lattice";
    options.output = "lattice.png"; // asked for, but not made
    CHECK(engine::picture_request(options).method == engine::PictureMethod::automatic);
    const engine::PictureMethod chosen = engine::chosen_method(engine::PictureMethod::automatic);
    CHECK((chosen == engine::PictureMethod::ray || chosen == engine::PictureMethod::texture));
    options.samples = "2";
    if (chosen == engine::PictureMethod::ray) {
        CHECK(engine::picture_request(options).method == chosen);
    } else {
        CHECK_THROWS_AS(engine::picture_request(options), sim::BadInput);
    }
    options.method = "ray";
    CHECK(engine::picture_request(options).method == engine::PictureMethod::ray);
    options.method = "texture";
    CHECK_THROWS_MATCHES(engine::picture_request(options), sim::BadInput,
                         MessageMatches(ContainsSubstring("--samples")));
    CHECK(engine::chosen_method(engine::PictureMethod::ray) == engine::PictureMethod::ray);
    CHECK(tests::rapidity({"fly", "lattice", "--headless", "--method", "magic"}) == 2);
}
