// SPDX-License-Identifier: Apache-2.0
// The source that the precompiled headers of the tests belong to.
