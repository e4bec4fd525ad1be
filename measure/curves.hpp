#pragma once

/// \file
/// Medians and percentiles of measured impacts, level by level.

#include <filesystem>
#include <string>

#include "lodlab/measure/degrade.hpp"

namespace measure {

/// The middle and the upper end of many values: the median is the lower of the two middle ones
/// where there are two, p90 the value that nine tenths do not exceed (nearest rank), p10 that of
/// one tenth. All are values that were measured.
struct Spread {
    double p10 = 0;
    double median = 0;
    double p90 = 0;
};
/// Throws lod::Error (input refused) for an empty list.
[[nodiscard]] Spread spread(std::vector<double> values);

/// One level of a curve, over all impacts.
struct CurveLevel {
    std::string name;  ///< "0", "1", ..., "exact"
    int impacts = 0;
    Spread impulse_error;
    Spread angle_error;  ///< [rad]
    Spread spin_error;   ///< [rad/s]
    Spread gap;          ///< [m]
    double most_gap = 0;
    int bound_violations = 0;  ///< gaps beyond their bound
    Spread delay;              ///< [s], negative: early
    Spread tests;
    Spread microseconds;
    int missed = 0;
};

/// How one contact model with one response degrades: its levels, the exact one last.
struct DegradationCurve {
    lod::ContactModel model{};
    lod::Response response{};
    std::vector<CurveLevel> levels;

    /// Whether the median error of the impulse falls from every level to the next.
    [[nodiscard]] bool falls_at_every_level() const;
};

/// Requires at least one impact.
[[nodiscard]] std::vector<DegradationCurve> curves_of(const Outcomes& outcomes);

/// The curves as a table with a head, one row a level: for spreadsheets. Numbers are the shortest
/// that read back to the same bits.
[[nodiscard]] std::string curves_csv(const std::vector<DegradationCurve>& curves);

/// Every outcome, without loss (see README.md of this folder), and back. Throws lod::Error: input
/// refused where a file is no such text, output failed.
[[nodiscard]] std::string outcomes_json(const Outcomes& outcomes);
/// `source` names the text in errors.
[[nodiscard]] Outcomes outcomes_from_json(const std::string& text, const std::string& source);
/// The file is complete or absent.
void save_outcomes(const std::filesystem::path& path, const Outcomes& outcomes);
/// Throws as outcomes_from_json does, and for a file that cannot be read.
[[nodiscard]] Outcomes load_outcomes(const std::filesystem::path& path);

}  // namespace measure
