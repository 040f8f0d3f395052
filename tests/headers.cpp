// SPDX-License-Identifier: Apache-2.0
// What the compiled headers of the tests belong to.
