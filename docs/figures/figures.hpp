// SPDX-License-Identifier: Apache-2.0
/// One function a figure: the SVG file's text. A figure that shows what a method answers asks the method, and the
/// program ends with an error when the answer is not the one in the caption.
#pragma once

#include <string>

namespace figures {

std::string gradient_descent_convergence();
std::string nineteen_ellipses();
std::string polygonal_sandwich();
std::string minkowski_sum();
std::string closest_features();
std::string separating_lines();
std::string first_contact();
std::string coverage();

/// Ends the program with the message unless `holds`.
void require(bool holds, const char* what);

}  // namespace figures
