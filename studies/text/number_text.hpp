#pragma once

/// @file
/// Numbers for people.

#include <string>

namespace unbruised::studies {

/// Four significant digits: 1.234, 0.25, 1.2e-07.
std::string short_number(double value);

/// Nine: a time among the steps of a run.
std::string nine_digits(double value);

/// Three: what is only an estimate, or a rate. 23.1, 0.25, 1,230
std::string three_digits(double value);

/// A part of 1 in per cent, three significant digits: "95 %", "-23.4 %"; what is not all never reads 100 %.
std::string percent(double part);
/// The same of a change: "+2 %", "-23.4 %".
std::string signed_percent(double change);

/// 1,234,567
std::string with_thousands(unsigned long long value);

/// A time span from microseconds to days: "12 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

/// "12 kB", "3.4 GB"
std::string bytes_text(double bytes);

}  // namespace unbruised::studies
