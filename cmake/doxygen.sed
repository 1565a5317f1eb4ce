# Plain comments of a header as comments for Doxygen.
/NOLINT|^ *[#}]/b
1s@^// (.*)@/// \\file\n/// \1@
s@^( *)//( |$)@\1///\2@
s@([^ /] +)// @\1///< @
# "#n" is no reference.
/\/\/\//s@#@\\#@g
