// The core for C++17: schuler.h with one type for each navigator. Nothing is allocated and nothing is thrown; objects are
// plain memory, which can be static, copied and forgotten.
//
//     schuler::navigator<schuler_f32_local_level_h0b4a0> navigator;
//     if (navigator.start(100.0, initial) == SCHULER_OK) { navigator.push(sample); }

#ifndef SCHULER_HPP
#define SCHULER_HPP

#include "schuler.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace schuler {

/// The functions of a navigator, by the type of its state.
template <class State>
struct functions;

/// A navigator: the state of one of schuler.h's navigators with its functions. Every function returns a result,
/// SCHULER_OK or what schuler.h says; it does not throw.
template <class State>
struct navigator {
    using call = functions<State>;
    using pair = typename call::pair;
    using increment = typename call::increment;
    using rates = typename call::rates;
    using solution = typename call::solution;
    using correction = typename call::correction;

    /// Bytes of its state, and of its stored form.
    static constexpr std::size_t size = sizeof(State);
    static constexpr std::size_t saved_size = call::saved_size;

    State state{};

    /// At so many samples per second, from a solution in local axes; `order` 0 is that of its window.
    [[nodiscard]] std::int32_t start(double rate_hz, const schuler_solution_f64& initial, std::uint32_t order = 0) noexcept
    {
        return call::start(&state, SCHULER_ABI, rate_hz, order, &initial);
    }

    /// The same in its own precision.
    [[nodiscard]] std::int32_t start(const pair& interval_s, const solution& initial, std::uint32_t order = 0) noexcept
    {
        return call::start_own(&state, SCHULER_ABI, &interval_s, order, &initial);
    }

    /// Takes a sample.
    [[nodiscard]] std::int32_t push(const increment& sample) noexcept { return call::push(&state, &sample); }

    /// Takes a sample of the rates at its start and at its end.
    [[nodiscard]] std::int32_t push(const rates& at_start, const rates& at_end) noexcept
    {
        return call::push_rates(&state, &at_start, &at_end);
    }

    /// Takes a sample of a length of its own; only of navigators that have it.
    template <class Call = call>
    [[nodiscard]] auto push_over(const increment& sample, const pair& interval_s) noexcept
        -> decltype(Call::push_over(nullptr, nullptr, nullptr))
    {
        return Call::push_over(&state, &sample, &interval_s);
    }

    /// Integrates what waits for look-ahead.
    [[nodiscard]] std::int32_t finish() noexcept { return call::finish(&state); }

    /// At the end of the last block, in double precision and local axes.
    [[nodiscard]] std::int32_t read(schuler_solution_f64& to) const noexcept { return call::read(&state, &to); }

    /// The same in its own precision and axes.
    [[nodiscard]] std::int32_t read_own(solution& to) const noexcept { return call::read_own(&state, &to); }

    /// At the newest sample.
    [[nodiscard]] std::int32_t predict(schuler_solution_f64& to) const noexcept { return call::predict(&state, &to); }

    /// The same in its own precision and axes.
    [[nodiscard]] std::int32_t predict_own(solution& to) const noexcept { return call::predict_own(&state, &to); }

    /// Corrects the state, as a filter does.
    [[nodiscard]] std::int32_t correct(const correction& by) noexcept { return call::correct(&state, &by); }

    /// Holds height, m, and vertical velocity, down positive, m/s.
    [[nodiscard]] std::int32_t hold_vertical(typename call::number altitude_m, typename call::number down_m_s) noexcept
    {
        return call::hold_vertical(&state, altitude_m, down_m_s);
    }

    /// Samples behind the solution that `read` gives.
    [[nodiscard]] std::int32_t integrated(std::uint64_t& samples) const noexcept
    {
        return call::integrated(&state, &samples);
    }

    /// Adds the state to a digest if a block has been completed; after `finish`, at the end, in any case.
    [[nodiscard]] std::int32_t digest(schuler_digest& running, bool at_end = false) const noexcept
    {
        return at_end ? call::digest_end(&state, &running) : call::digest(&state, &running);
    }

    /// Writes its stored form.
    [[nodiscard]] std::int32_t save(std::uint8_t (&bytes)[saved_size]) const noexcept
    {
        return call::save(&state, bytes, saved_size);
    }

    /// Goes on from a stored form.
    [[nodiscard]] std::int32_t restore(const std::uint8_t* bytes, std::size_t length) noexcept
    {
        return call::restore(&state, SCHULER_ABI, bytes, length);
    }
};

#define SCHULER_NAVIGATOR(name, type, NAME)                       \
    template <>                                                   \
    struct functions<schuler_##name> {                            \
        SCHULER_FUNCTIONS(name, type, NAME)                       \
    };
#define SCHULER_NAVIGATOR_ANY(name, type, NAME)                   \
    template <>                                                   \
    struct functions<schuler_##name> {                            \
        SCHULER_FUNCTIONS(name, type, NAME)                       \
        static constexpr auto push_over = schuler_##name##_push_over; \
        static constexpr auto push_rates_over = schuler_##name##_push_rates_over; \
    };
#define SCHULER_FUNCTIONS(name, type, NAME)                           \
    using number = decltype(schuler_pair_##type::value);              \
    using pair = schuler_pair_##type;                                 \
    using increment = schuler_increment_##type;                       \
    using rates = schuler_rates_##type;                               \
    using solution = schuler_solution_##type;                         \
    using correction = schuler_correction_##type;                     \
    static constexpr std::size_t saved_size = SCHULER_##NAME##_SAVED; \
    static constexpr auto start = schuler_##name##_start;             \
    static constexpr auto start_own = schuler_##name##_start_own;     \
    static constexpr auto push = schuler_##name##_push;               \
    static constexpr auto push_rates = schuler_##name##_push_rates;   \
    static constexpr auto finish = schuler_##name##_finish;           \
    static constexpr auto read = schuler_##name##_read;               \
    static constexpr auto read_own = schuler_##name##_read_own;       \
    static constexpr auto predict = schuler_##name##_predict;         \
    static constexpr auto predict_own = schuler_##name##_predict_own; \
    static constexpr auto correct = schuler_##name##_correct;         \
    static constexpr auto hold_vertical = schuler_##name##_hold_vertical; \
    static constexpr auto integrated = schuler_##name##_integrated;   \
    static constexpr auto digest = schuler_##name##_digest;           \
    static constexpr auto digest_end = schuler_##name##_digest_end;   \
    static constexpr auto save = schuler_##name##_save;               \
    static constexpr auto restore = schuler_##name##_restore;

// Every navigator: `host/c/tests/header.rs` writes these lines.
// <navigators>
SCHULER_NAVIGATOR(f64_local_level_h0b4a0, f64, F64_LOCAL_LEVEL_H0B4A0)
SCHULER_NAVIGATOR_ANY(f64_local_level_h0b4a0_any, f64, F64_LOCAL_LEVEL_H0B4A0_ANY)
SCHULER_NAVIGATOR(f64_local_level_h2b4a2, f64, F64_LOCAL_LEVEL_H2B4A2)
SCHULER_NAVIGATOR_ANY(f64_local_level_h2b4a2_any, f64, F64_LOCAL_LEVEL_H2B4A2_ANY)
SCHULER_NAVIGATOR_ANY(f64_local_level_textbook, f64, F64_LOCAL_LEVEL_TEXTBOOK)
SCHULER_NAVIGATOR(f64_earth_fixed_h0b4a0, f64, F64_EARTH_FIXED_H0B4A0)
SCHULER_NAVIGATOR_ANY(f64_earth_fixed_h0b4a0_any, f64, F64_EARTH_FIXED_H0B4A0_ANY)
SCHULER_NAVIGATOR(f64_earth_fixed_h2b4a2, f64, F64_EARTH_FIXED_H2B4A2)
SCHULER_NAVIGATOR_ANY(f64_earth_fixed_h2b4a2_any, f64, F64_EARTH_FIXED_H2B4A2_ANY)
SCHULER_NAVIGATOR_ANY(f64_earth_fixed_textbook, f64, F64_EARTH_FIXED_TEXTBOOK)
SCHULER_NAVIGATOR(f32_local_level_h0b4a0, f32, F32_LOCAL_LEVEL_H0B4A0)
SCHULER_NAVIGATOR_ANY(f32_local_level_h0b4a0_any, f32, F32_LOCAL_LEVEL_H0B4A0_ANY)
SCHULER_NAVIGATOR(f32_local_level_h2b4a2, f32, F32_LOCAL_LEVEL_H2B4A2)
SCHULER_NAVIGATOR_ANY(f32_local_level_h2b4a2_any, f32, F32_LOCAL_LEVEL_H2B4A2_ANY)
SCHULER_NAVIGATOR_ANY(f32_local_level_textbook, f32, F32_LOCAL_LEVEL_TEXTBOOK)
SCHULER_NAVIGATOR(f32_earth_fixed_h0b4a0, f32, F32_EARTH_FIXED_H0B4A0)
SCHULER_NAVIGATOR_ANY(f32_earth_fixed_h0b4a0_any, f32, F32_EARTH_FIXED_H0B4A0_ANY)
SCHULER_NAVIGATOR(f32_earth_fixed_h2b4a2, f32, F32_EARTH_FIXED_H2B4A2)
SCHULER_NAVIGATOR_ANY(f32_earth_fixed_h2b4a2_any, f32, F32_EARTH_FIXED_H2B4A2_ANY)
SCHULER_NAVIGATOR_ANY(f32_earth_fixed_textbook, f32, F32_EARTH_FIXED_TEXTBOOK)
SCHULER_NAVIGATOR(f32x2_local_level_h0b4a0, f32, F32X2_LOCAL_LEVEL_H0B4A0)
SCHULER_NAVIGATOR_ANY(f32x2_local_level_h0b4a0_any, f32, F32X2_LOCAL_LEVEL_H0B4A0_ANY)
SCHULER_NAVIGATOR(f32x2_local_level_h2b4a2, f32, F32X2_LOCAL_LEVEL_H2B4A2)
SCHULER_NAVIGATOR_ANY(f32x2_local_level_h2b4a2_any, f32, F32X2_LOCAL_LEVEL_H2B4A2_ANY)
SCHULER_NAVIGATOR(f32x2_earth_fixed_h0b4a0, f32, F32X2_EARTH_FIXED_H0B4A0)
SCHULER_NAVIGATOR_ANY(f32x2_earth_fixed_h0b4a0_any, f32, F32X2_EARTH_FIXED_H0B4A0_ANY)
SCHULER_NAVIGATOR(f32x2_earth_fixed_h2b4a2, f32, F32X2_EARTH_FIXED_H2B4A2)
SCHULER_NAVIGATOR_ANY(f32x2_earth_fixed_h2b4a2_any, f32, F32X2_EARTH_FIXED_H2B4A2_ANY)
// </navigators>

#undef SCHULER_NAVIGATOR
#undef SCHULER_NAVIGATOR_ANY
#undef SCHULER_FUNCTIONS

static_assert(std::is_trivially_copyable<navigator<schuler_f32_local_level_h0b4a0>>::value, "plain memory");

} // namespace schuler

#endif // SCHULER_HPP
