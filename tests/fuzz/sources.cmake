# What turns bytes into calls of the C interface: for libFuzzer, and for fuzz_replay among the tests.
set(c_face_sources batches.cpp boxes.cpp c_face.cpp constructors.cpp index.cpp motion.cpp polygons.cpp topology.cpp)
