// Wear of a slider-crank's gudgeon over thousands of cycles on worn shapes that act back. Shares nothing with the library: absolute
// coordinates with multipliers, classical Runge-Kutta steps of equal length, growth of depths by the weights of these steps.
// README.md says what is solved and how to call it. SI units throughout.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr double PI = 3.14159265358979323846;
constexpr double CRANK_M = 0.05, CRANK_RAD_S = 10.0 * PI; // 300 rpm
constexpr double ROD_M = 0.12, ROD_KG = 0.21, ROD_KG_M2 = 2.5e-4, SLIDER_KG = 0.14;
constexpr double GRAVITY_M_S2 = 9.81, LOAD_N = -500.0; // along -y; along x on the slider
constexpr double BEARING_M = 0.01, CLEARANCE_M = 1e-4, LENGTH_M = 0.02;
constexpr double JOURNAL_M = BEARING_M - CLEARANCE_M;
constexpr double ELASTIC_PA = 207e9 / (2.0 * (1.0 - 0.3 * 0.3)); // E*
constexpr double FOUNDATION_PA_M = 3.0 * PI * ELASTIC_PA / (16.0 * BEARING_M);
constexpr double DAMPING_S_M = 0.1425 / 1e-3; // χ/v0, v0 held
constexpr double WEAR_I_M2_N = 2e-14, WEAR_J_M2_N = 1e-14;

struct Options {
    int sectors = 360, jumps = 64, cycles = 4000, transient_turns = 1, order = 2;
    double step_s = 2e-6;
    bool midway = true; // radii R_i + a and R_j - a in place of R_i and R_j
    std::string shape, depths, turn;
};

/// Depths of the sectors of bearing and journal.
using Depths = std::array<std::vector<double>, 2>;

/// Centre of the rod x, y, its angle, abscissa of the slider; then their rates.
using State = std::array<double, 8>;

/// Sums over the foundation.
struct Load {
    double force_x = 0, force_y = 0;  // on the rod's bearing; the slider gets the opposite
    double couple_rod = 0;            // beside that force in the bearing's centre
    double sum = 0, path_w = 0, loss_w = 0, stored_j = 0, deepest = 0;
};

/// Cubic B-splines of both surfaces and the springs between them.
class Foundation {
public:
    Foundation(const Depths &depths, bool midway)
        : count(depths[0].size()), sector_rad(2.0 * PI / count), midway(midway), journal(depths[1]),
          bearing_at_middle(count), cosines(count), sines(count) {
        for (int s = 0; s < count; ++s) {
            const auto &h = depths[0];
            bearing_at_middle[s] = (h[(s + count - 1) % count] + 4.0 * h[s] + h[(s + 1) % count]) / 6.0;
            cosines[s] = std::cos((s + 0.5) * sector_rad);
            sines[s] = std::sin((s + 0.5) * sector_rad);
        }
    }

    /// Adds to `growth` per `weight`, s, where that is given: F_s |v_s| of each sector of bearing and journal.
    Load load(const State &q, double pin_x, double pin_y, double pin_vx, double pin_vy, double weight, Depths *growth) const {
        const double angle = q[2], spin = q[6]; // the slider does not turn
        const double c = std::cos(angle), s = std::sin(angle);
        const double ex = pin_x - (q[0] + 0.5 * ROD_M * c), ey = pin_y - (q[1] + 0.5 * ROD_M * s);
        const double vx = pin_vx - (q[4] - 0.5 * ROD_M * s * spin), vy = pin_vy - (q[5] + 0.5 * ROD_M * c * spin);
        Load sum;
        const double distance = std::hypot(ex, ey);
        if (distance <= CLEARANCE_M) return sum;
        const double stiffness = FOUNDATION_PA_M * BEARING_M * sector_rad * LENGTH_M;
        const double towards = std::atan2(ey, ex) - angle, reach = std::acos(CLEARANCE_M / distance) + 2.0 * sector_rad;
        const int first = (int)std::floor((towards - reach) / sector_rad), last = (int)std::ceil((towards + reach) / sector_rad);
        // The journal's spline: its control values stand at the middles of its sectors; sector k of the bearing lies at k + turn of it.
        const double turn = angle / sector_rad, whole = std::floor(turn), u = turn - whole;
        const double value[4] = {(1 - u) * (1 - u) * (1 - u) / 6, (3 * u * u * u - 6 * u * u + 4) / 6,
                                 (-3 * u * u * u + 3 * u * u + 3 * u + 1) / 6, u * u * u / 6};
        const double slope[4] = {-(1 - u) * (1 - u) / 2, (3 * u * u - 4 * u) / 2, (-3 * u * u + 2 * u + 1) / 2, u * u / 2};
        for (int k = first; k <= last; ++k) {
            const int own = wrapped(k);
            const double nx = cosines[own] * c - sines[own] * s, ny = sines[own] * c + cosines[own] * s;
            const double along = ex * nx + ey * ny - CLEARANCE_M, across = ey * nx - ex * ny;
            double depth_j = 0, slope_j = 0;
            int beside[4];
            for (int m = 0; m < 4; ++m) {
                beside[m] = wrapped(k + (int)whole + m - 1);
                depth_j += value[m] * journal[beside[m]];
                slope_j += slope[m] / sector_rad * journal[beside[m]];
            }
            const double penetration = along - bearing_at_middle[own] - depth_j;
            if (penetration <= 0) continue;
            const double rate = vx * nx + vy * ny + spin * (across - slope_j);
            const double elastic = stiffness * penetration, force = elastic * std::max(0.0, 1.0 + DAMPING_S_M * rate);
            const double arm = BEARING_M + (midway ? 0.5 * along : 0.0);
            const double sliding = std::fabs(vy * nx - vx * ny - arm * spin);
            sum.force_x += force * nx;
            sum.force_y += force * ny;
            sum.couple_rod -= force * (across - slope_j);
            sum.sum += force;
            sum.path_w += force * sliding;
            sum.loss_w += (force - elastic) * rate;
            sum.stored_j += 0.5 * elastic * penetration;
            sum.deepest = std::max(sum.deepest, penetration);
            if (growth) {
                (*growth)[0][own] += weight * force * sliding;
                for (int m = 0; m < 4; ++m) (*growth)[1][beside[m]] += weight * value[m] * force * sliding;
            }
        }
        return sum;
    }

    const int count;
    const double sector_rad;

private:
    int wrapped(int k) const { return ((k % count) + count) % count; }

    const bool midway;
    const std::vector<double> journal;
    std::vector<double> bearing_at_middle, cosines, sines;
};

/// A turn of the crank: friction path, growth of depths, greatest force, residual of the energy account.
struct Turn {
    double path_j = 0, peak_n = 0, energy_j = 0;
    Depths growth;
};

class SliderCrank {
public:
    SliderCrank(const Foundation &foundation, double step_s)
        : foundation(foundation), steps((int)std::lround(2.0 * PI / CRANK_RAD_S / step_s)), step(2.0 * PI / CRANK_RAD_S / steps) {}

    /// Outer dead centre, journal pressed against the side of the load as deep as the load at rest presses it, nothing swinging.
    State start() const {
        double low = CLEARANCE_M, high = CLEARANCE_M + 1e-3;
        const auto at = [](double distance) {
            const double spin = -CRANK_M * CRANK_RAD_S / (ROD_M - distance);
            return State{CRANK_M + 0.5 * ROD_M, 0, 0, CRANK_M + ROD_M - distance,
                         0, CRANK_M * CRANK_RAD_S + 0.5 * ROD_M * spin, spin, 0};
        };
        for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (low + high);
            State rest = at(middle);
            rest[5] = rest[6] = 0;
            const bool holds = foundation.load(rest, rest[3], 0, 0, 0, 0, nullptr).force_x < LOAD_N;
            (holds ? high : low) = middle;
        }
        return at(high);
    }

    /// Runs a turn; `file` receives 401 rows of it.
    Turn turn(State &q, FILE *file) const {
        if (file && steps % 400 != 0) throw std::runtime_error("--turn needs steps that divide a turn into a multiple of 400");
        Turn turn;
        turn.growth = {std::vector<double>(foundation.count), std::vector<double>(foundation.count)};
        const double before = energy(q);
        double supplied = 0;
        for (int k = 0; k < steps; ++k) {
            const double time = k * step;
            if (file && k % (steps / 400) == 0) row(file, time, q, turn.path_j);
            State sum{}, stage = q, rate;
            const double offsets[4] = {0, 0.5, 0.5, 1}, weights[4] = {step / 6, step / 3, step / 3, step / 6};
            for (int m = 0; m < 4; ++m) {
                if (m) for (int i = 0; i < 8; ++i) stage[i] = q[i] + offsets[m] * step * rate[i];
                const Load load = foundation.load(stage, stage[3], 0, stage[7], 0, weights[m], &turn.growth);
                double power;
                rate = derivative(time + offsets[m] * step, stage, load, power);
                for (int i = 0; i < 8; ++i) sum[i] += weights[m] * rate[i];
                turn.path_j += weights[m] * load.path_w;
                supplied += weights[m] * (power - load.loss_w);
                if (m == 0) turn.peak_n = std::max(turn.peak_n, std::hypot(load.force_x, load.force_y));
            }
            for (int i = 0; i < 8; ++i) q[i] += sum[i];
            project(time + step, q);
        }
        if (file) row(file, steps * step, q, turn.path_j);
        turn.energy_j = energy(q) - before - supplied;
        const double area[2] = {BEARING_M * foundation.sector_rad * LENGTH_M, JOURNAL_M * foundation.sector_rad * LENGTH_M};
        const double wear[2] = {WEAR_I_M2_N, WEAR_J_M2_N};
        for (int side = 0; side < 2; ++side) for (double &own : turn.growth[side]) own *= wear[side] / area[side];
        return turn;
    }

private:
    /// Accelerations with the multipliers of the crank pin; power of pin and load.
    State derivative(double time, const State &q, const Load &load, double &power) const {
        const double c = std::cos(q[2]), s = std::sin(q[2]), half = 0.5 * ROD_M;
        const double crank_c = CRANK_M * std::cos(CRANK_RAD_S * time), crank_s = CRANK_M * std::sin(CRANK_RAD_S * time);
        const double couple = half * (c * load.force_y - s * load.force_x) + load.couple_rod;
        // Big end: x - half c, y - half s follows the crank pin. J M^-1 J' λ = what the free accelerations lack.
        const double free_x = load.force_x / ROD_KG, free_y = load.force_y / ROD_KG - GRAVITY_M_S2, free_w = couple / ROD_KG_M2;
        const double square = q[6] * q[6], speed2 = CRANK_RAD_S * CRANK_RAD_S;
        const double lack_x = -speed2 * crank_c - (free_x + half * s * free_w + half * c * square);
        const double lack_y = -speed2 * crank_s - (free_y - half * c * free_w + half * s * square);
        const double axx = 1 / ROD_KG + half * half * s * s / ROD_KG_M2, ayy = 1 / ROD_KG + half * half * c * c / ROD_KG_M2;
        const double axy = -half * half * s * c / ROD_KG_M2, determinant = axx * ayy - axy * axy;
        const double pin_x = (ayy * lack_x - axy * lack_y) / determinant, pin_y = (axx * lack_y - axy * lack_x) / determinant;
        power = CRANK_RAD_S * (-pin_x * crank_s + pin_y * crank_c) + LOAD_N * q[7];
        return {q[4], q[5], q[6], q[7], free_x + pin_x / ROD_KG, free_y + pin_y / ROD_KG,
                free_w + half * (s * pin_x - c * pin_y) / ROD_KG_M2, (LOAD_N - load.force_x) / SLIDER_KG};
    }

    /// Brings the big end back onto the crank pin, where it has drifted by the error of a step.
    void project(double time, State &q) const {
        const double c = 0.5 * ROD_M * std::cos(q[2]), s = 0.5 * ROD_M * std::sin(q[2]);
        const double crank_c = CRANK_M * std::cos(CRANK_RAD_S * time), crank_s = CRANK_M * std::sin(CRANK_RAD_S * time);
        q[0] = crank_c + c;
        q[1] = crank_s + s;
        q[4] = -CRANK_RAD_S * crank_s - s * q[6];
        q[5] = CRANK_RAD_S * crank_c + c * q[6];
    }

    double energy(const State &q) const {
        const double kinetic = ROD_KG * (q[4] * q[4] + q[5] * q[5]) + ROD_KG_M2 * q[6] * q[6] + SLIDER_KG * q[7] * q[7];
        return 0.5 * kinetic + ROD_KG * GRAVITY_M_S2 * q[1] + foundation.load(q, q[3], 0, q[7], 0, 0, nullptr).stored_j;
    }

    void row(FILE *file, double time, const State &q, double path) const {
        const Load load = foundation.load(q, q[3], 0, q[7], 0, 0, nullptr);
        std::fprintf(file, "%.9g,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g\n", time, q[2], q[3], q[6], q[7], path,
                     std::hypot(load.force_x, load.force_y), load.deepest);
    }

    const Foundation &foundation;
    const int steps;
    const double step;
};

FILE *opened(const std::string &path, const char *mode) {
    FILE *file = std::fopen(path.c_str(), mode);
    if (!file) throw std::runtime_error("cannot open " + path);
    return file;
}

/// Depths of a file that --depths wrote.
Depths read_shape(const std::string &path, int sectors) {
    Depths depths;
    FILE *file = opened(path, "r");
    int sector;
    double bearing, journal;
    if (std::fscanf(file, "%*[^\n]") == 0)
        while (std::fscanf(file, "%d,%lf,%lf", &sector, &bearing, &journal) == 3) {
            depths[0].push_back(bearing);
            depths[1].push_back(journal);
        }
    std::fclose(file);
    if ((int)depths[0].size() != sectors) throw std::runtime_error(path + " has not as many rows as there are sectors");
    return depths;
}

/// A settled turn on the unworn or worn shape.
Turn cycle(const Depths &depths, const Options &options, FILE *file = nullptr) {
    const Foundation foundation(depths, options.midway);
    const SliderCrank mechanism(foundation, options.step_s);
    State state = mechanism.start();
    for (int k = 0; k < options.transient_turns; ++k) mechanism.turn(state, nullptr);
    return mechanism.turn(state, file);
}

/// depths + cycles * growth
Depths moved(Depths depths, double cycles, const Depths &growth) {
    for (int side = 0; side < 2; ++side)
        for (size_t s = 0; s < depths[side].size(); ++s) depths[side][s] += cycles * growth[side][s];
    return depths;
}

double volume(const std::vector<double> &depths, double radius) {
    double sum = 0;
    for (double own : depths) sum += own;
    return sum * radius * 2.0 * PI / depths.size() * LENGTH_M;
}

double greatest(const std::vector<double> &depths) { return *std::max_element(depths.begin(), depths.end()); }

void print(double cycles, const Turn &turn, const Depths &depths) {
    std::printf("%.6g,%.12g,%.12g,%.12g,%.9g,%.9g,%.9g,%.3g\n", cycles, turn.path_j, volume(depths[0], BEARING_M),
                volume(depths[1], JOURNAL_M), greatest(depths[0]), greatest(depths[1]), turn.peak_n, turn.energy_j);
    std::fflush(stdout);
}

Options read(int count, char **words) {
    Options options;
    for (int k = 1; k + 1 < count; k += 2) {
        const std::string name = words[k], text = words[k + 1];
        if (name == "--sectors") options.sectors = std::stoi(text);
        else if (name == "--jumps") options.jumps = std::stoi(text);
        else if (name == "--cycles") options.cycles = std::stoi(text);
        else if (name == "--transient") options.transient_turns = std::stoi(text);
        else if (name == "--order" && (text == "1" || text == "2")) options.order = std::stoi(text);
        else if (name == "--step") options.step_s = std::stod(text);
        else if (name == "--radii" && (text == "midway" || text == "nominal")) options.midway = text == "midway";
        else if (name == "--shape") options.shape = text;
        else if (name == "--depths") options.depths = text;
        else if (name == "--turn") options.turn = text;
        else throw std::runtime_error("unknown option " + name + " " + text);
    }
    if (count % 2 == 0) throw std::runtime_error("option without a value");
    return options;
}

} // namespace

int main(int count, char **words) try {
    const Options options = read(count, words);
    Depths depths = {std::vector<double>(options.sectors), std::vector<double>(options.sectors)};
    if (!options.shape.empty()) depths = read_shape(options.shape, options.sectors);
    std::printf("cycle,path_work_j,bearing_volume_m3,journal_volume_m3,bearing_depth_m,journal_depth_m,peak_force_n,energy_residual_j\n");
    FILE *file = options.turn.empty() ? nullptr : opened(options.turn, "w");
    if (file) std::fprintf(file, "time_s,rod_angle,slider_x_m,rod_rate,slider_rate,path_work_j,normal_force_n,deepest_m\n");
    Turn turn = cycle(depths, options, file);
    if (file) std::fclose(file);
    print(0, turn, depths);
    for (int k = 0; k < options.jumps; ++k) {
        const double jump = (double)options.cycles / options.jumps;
        Depths next = moved(depths, jump, turn.growth);
        if (options.order == 2) {
            const Turn there = cycle(next, options);
            next = moved(moved(depths, 0.5 * jump, turn.growth), 0.5 * jump, there.growth);
        }
        depths = next;
        turn = cycle(depths, options);
        print((k + 1) * jump, turn, depths);
    }
    if (!options.depths.empty()) {
        FILE *out = opened(options.depths, "w");
        std::fprintf(out, "sector,bearing_depth_m,journal_depth_m\n");
        for (int s = 0; s < options.sectors; ++s) std::fprintf(out, "%d,%.12g,%.12g\n", s, depths[0][s], depths[1][s]);
        std::fclose(out);
    }
} catch (const std::exception &error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
}
