// SPDX-License-Identifier: Apache-2.0
/// Every named method of vesica_methods.h as a call whose result is bytes.
#pragma once

#include <vector>

#include "environment/calls.hpp"

namespace environment {

struct MethodCall {
  int kind_a, kind_b;  ///< of the shapes that it takes
  properties::Scalar scalar;
  const char* name;
  Bytes (*ask)(const Input& input);
};
const std::vector<MethodCall>& method_calls();

}  // namespace environment
