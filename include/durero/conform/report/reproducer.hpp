#pragma once
/// A reproducer is a program in a system's own language that shows a failure and stands alone. It is made from the
/// template that the system's file names (System::reproducer). A template is such a program with
///
///   @(name)          in place of a number, or of a text
///   @esfera LINE     lines that stand for each element of that tipo; of several, @cono,tronco LINE; of any, @each
///   LINE.
///                    Such lines that follow each other are written for the first element, then for the second, …
///
/// Names for an element: name, index (from 0), and by its tipo centro, vector, radio, proporcion, altura, a, b, c
/// (vertices); of one with an axis also half (altura/2), middle, top (the other end of the axis), base_radius,
/// top_radius; with the vector also x_axis and y_axis (x × y is the vector), from_z and from_y (x, y, z and w of a
/// rotation that takes that axis to it), turned_x and turned_y (where one from the z axis takes these) and offset
/// (centro·vector). Everywhere: p, v, unit (v/|v|), length
/// (|v|), segment (a power of two f: no element that has an end is beyond p + f·v), count (of the elements), file (the
/// program's), about (what it shows, with the exact answer), expected (as a system answers), and the words of
/// System::reproducer. A vector's coordinates stand with commas between, or one by one as @(centro.x). What has
/// several lines gets what stands before it on each.
///
/// The program writes the system's answer in a line "got: " in the form that question.hpp gives; for the reader it also
/// writes a line "expected: @(expected)".

#include <atomic>
#include <string>

#include "durero/conform/ask/system_file.hpp"
#include "durero/conform/report/report.hpp"

namespace durero::conform {

/// The text of the program. `about` replaces @(about), and `file` is the program's name. Throws std::runtime_error,
/// with the line, where the template uses a name that has no meaning there.
std::string reproducer_text(const System& system, const Finding& finding, const std::string& about,
                            const std::string& file);

/// The output of a reproducer that was run.
struct Reproduction {
  std::string output{};                ///< the lines from "got: " on
  Verdict verdict = Verdict::skipped;  ///< the verdict on the answer it got
  std::string words{};                 ///< without an answer: how the program ended, and the end of its output
};

/// Runs the program in a folder of its own, by the commands of System::reproducer.
Reproduction reproduced(const System& system, const Finding& finding, const std::string& program,
                        const std::string& file, const std::atomic<bool>& stop);

}  // namespace durero::conform
