// SPDX-License-Identifier: Apache-2.0
/// Everything in the core.
#pragma once

#include <vesica/bounds.hpp>
#include <vesica/check.hpp>
#include <vesica/construct.hpp>
#include <vesica/overlap.hpp>
#include <vesica/shapes.hpp>
