// A flight in C++17: a vehicle at rest on the equator, in single and in double precision, stored and restored on the way.

#include "schuler.hpp"

#include <cstdio>
#include <cstdlib>

namespace {

void must(std::int32_t status)
{
    if (status != SCHULER_OK) {
        std::fprintf(stderr, "flight: %s: %s\n", schuler_result_name(status), schuler_result_text(status));
        std::exit(1);
    }
}

template <class State, class Increment>
std::uint64_t fly(const schuler_solution_f64& initial, const Increment& sample)
{
    schuler::navigator<State> navigator;
    schuler_digest running{};
    std::uint8_t stored[schuler::navigator<State>::saved_size];
    std::uint64_t value = 0;

    must(schuler_digest_start(&running, SCHULER_ABI));
    must(navigator.start(100.0, initial));
    for (int i = 0; i < 1000; i++) {
        must(navigator.push(sample));
        must(navigator.digest(running));
        if (i == 501) {
            must(navigator.save(stored));
            navigator = {};
            must(navigator.restore(stored, sizeof stored));
        }
    }
    must(navigator.finish());
    must(navigator.digest(running, true));
    must(schuler_digest_value(&running, &value));

    schuler_solution_f64 at{};
    must(navigator.predict(at));
    std::printf("%zu bytes, stored in %zu; %.9f m, digest %08lx%08lx\n", navigator.size, navigator.saved_size,
                at.position[2].value, static_cast<unsigned long>(value >> 32),
                static_cast<unsigned long>(value & 0xffffffffU));
    return value;
}

} // namespace

int main()
{
    schuler_solution_f64 initial{};
    const schuler_vector_f64 none{};
    const schuler_increment_f64 twice{ { 7.292115e-7, 0.0, 0.0 }, { 0.0, 0.0, -0.0978 } };
    const schuler_increment_f32 single{ { 7.292115e-7F, 0.0F, 0.0F }, { 0.0F, 0.0F, -0.0978F } };

    must(schuler_solution_f64_from(0.0, 0.1, 50.0, &none, &none, &initial));
    static_assert(schuler::navigator<schuler_f32_local_level_h0b4a0>::size <= 512, "it fits");
    const bool differ = fly<schuler_f32_local_level_h0b4a0>(initial, single)
                        != fly<schuler_f64_earth_fixed_h2b4a2>(initial, twice);
    return differ ? 0 : 1;
}
