#pragma once

#include "sim/spacetime/lanes.h"
#include "sim/spacetime/mino.h"
#include "sim/spacetime/sine_cosine.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <limits>
#include <vector>

/// Rays in Mino time as ways through the chart, and what lies along them. All in the homogeneous coordinates
/// (u x, u y, u z, u) of the chart's places (x, y, z), u = 1/r: with them infinity is a place like others, and a cubic
/// through a step is good however far the step leads.
namespace sim {

/// The turn of Boyer and Lindquist's phi to the chart's azimuth but for the factor r + i a: x + i y =
/// (r + i a) sin(theta) exp(i (phi + g)), g = a/(r_+ - r_-) ln((r - r_+)/(r - r_-)) (Kerr & Schild 1965), as a function
/// of u. It vanishes at infinity.
double chart_turn(const MinoHole& hole, double u);

/// One step of a ray into the past.
struct MinoSegment {
    const MinoEye* eye;
    MinoRay<double> ray;
    MinoState<double> from;
    MinoState<double> to;
    double step; ///< of tau

    /// The cubic through places and directions at both ends, as Bezier points (u x, u y, u z, u). Not finite within a
    /// horizon of a rotating hole.
    std::array<glm::dvec4, 4> bezier() const;
    /// Chart place at `share` of the step, by a step of the integrator to there.
    glm::dvec3 place(double share) const;
};

/// Looks at a step of the ray that eye direction number `ray` has. Returns the share of the step at which the ray is
/// stopped; more than 1: it goes on.
using MinoVisitor = std::function<double(std::size_t ray, const MinoSegment& segment)>;

/// Which steps may touch watched balls, for all lanes at once. A moving ball may be anywhere on its line: Mino time
/// does not tell when.
class MinoWatch {
  public:
    MinoWatch(const MinoEye& eye, const WatchedPlaces& places);

    template <bool rotating, class T>
    auto may_touch(const MinoState<T>& from, const MinoState<T>& to, double step) const {
        const T zero(0.0);
        auto touch = zero < T(-1.0);
        const T most_u = larger(from.y.u, to.y.u);
        const T least_u = zero - larger(zero - from.y.u, zero - to.y.u);
        // Between the ends u may pass a turning point: by up to an eighth of the square of the step's turn.
        const double beyond = 1.0 + 0.25 * step * step;
        const auto in_shells =
            (T(beyond) * most_u > T(least_inverse_radius_)) & ((T(2.0 - beyond) * least_u) < T(most_inverse_radius_));
        if (!any_lane(in_shells)) {
            return touch;
        }
        const Place<T> a = place_of<rotating>(from);
        const Place<T> b = place_of<rotating>(to);
        for (const Ball& ball : balls_) {
            const auto offset = [&](const Place<T>& p, const T& u) {
                const Place<T> o{p.x - T(ball.centre.x) * u, p.y - T(ball.centre.y) * u, p.z - T(ball.centre.z) * u};
                const T along = T(ball.axis.x) * o.x + T(ball.axis.y) * o.y + T(ball.axis.z) * o.z;
                return Place<T>{o.x - T(ball.axis.x) * along, o.y - T(ball.axis.y) * along,
                                o.z - T(ball.axis.z) * along};
            };
            const Place<T> start = offset(a, from.y.u);
            const Place<T> end = offset(b, to.y.u);
            const Place<T> middle{T(0.5) * (start.x + end.x), T(0.5) * (start.y + end.y), T(0.5) * (start.z + end.z)};
            const Place<T> half{middle.x - start.x, middle.y - start.y, middle.z - start.z};
            // The curve strays from its chord by up to an eighth of the square of the turn: sum of three lengths,
            // squared, below three times the sum of squares.
            const T strays2 =
                T(0.0625 * step * step * step * step + (rotating ? 4e-6 : 0.0)) * larger(length2(start), length2(end));
            const T radius = T(ball.radius * beyond) * most_u;
            touch = touch | (length2(middle) < T(3.0) * (radius * radius + length2(half) + strays2));
        }
        if constexpr (rotating) {
            // Closer in the series of the chart's turn is not good to the 2e-3 rad allowed for above.
            touch = touch | (T(beyond * horizon_) * most_u > T(0.6));
        }
        return touch & in_shells;
    }

  private:
    template <class T>
    struct Place {
        T x, y, z;
    };
    template <class T>
    static T larger(const T& a, const T& b) {
        return select(a > b, a, b);
    }
    template <class T>
    static T length2(const Place<T>& p) {
        return p.x * p.x + p.y * p.y + p.z * p.z;
    }
    template <class Integer, int N>
    static bool any_lane(const LaneMask<Integer, N>& mask) {
        bool result = false;
        for (int lane = 0; lane < N; ++lane) {
            result |= mask[lane];
        }
        return result;
    }

    /// (u x, u y, u z).
    template <bool rotating, class T>
    Place<T> place_of(const MinoState<T>& s) const {
        if constexpr (!rotating) {
            return {s.y.x, s.y.y, s.y.z};
        } else {
            T turn(0.0);
            for (std::size_t k = turn_series_.size(); k-- > 0;) {
                turn = s.y.u * (T(turn_series_[k]) + turn);
            }
            const SineCosine<T> turned = sine_cosine(s.z + T(azimuth_) + turn);
            const T au = T(spin_) * s.y.u;
            const T x = s.y.x - au * s.y.y;
            const T y = s.y.y + au * s.y.x;
            return {turned.cosine * x - turned.sine * y, turned.sine * x + turned.cosine * y, s.y.z};
        }
    }

    struct Ball {
        glm::dvec3 centre;
        glm::dvec3 axis; ///< unit: anywhere along it; or zero
        double radius;
    };

    double spin_;
    double azimuth_;
    double horizon_;
    std::array<double, 12> turn_series_{}; ///< g = series[0] u + series[1] u^2 + ...
    std::vector<Ball> balls_;
    double least_inverse_radius_ = std::numeric_limits<double>::infinity(); ///< nothing is met outside
    double most_inverse_radius_ = 0.0;
};

/// As trace_mino_sky in double precision, showing `visit` every step that may touch a watched ball, each ray's in
/// order. Stopped rays end as hit_object; crossings of the plane that lie beyond are left out.
void trace_mino_sky(const MinoEye& eye, std::span<const glm::dvec3> seen, const RaySettings& settings,
                    std::span<SkyRay> rays, std::span<PlaneCrossings> crossings, const MinoWatch& watch,
                    const MinoVisitor& visit);

} // namespace sim
