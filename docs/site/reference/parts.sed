# The parts of a comment ("Returns: ...") as paragraphs of their own, for doxygen.
s/^\( \* \|\/\/\/ \)\(Requires\|Returns\|Errors\|Accuracy\|Cost\|Since\|Bound\|Laws\): */\1\\par \2\n\1/
