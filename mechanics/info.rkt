#lang info
(define name "mechanics")
(define raco-commands
  '(("mechanics" (submod mechanics/lang/command/raco main)
     "show programs typeset, as pages or LaTeX; a prompt; help" #f)))
