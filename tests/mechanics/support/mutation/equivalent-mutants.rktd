;; Mutants that no behaviour tells from the library: (file "the line as it was" "as it is" "reason")
