#lang info
(define name "mechanics")
(define raco-commands
  '(("mechanics" (submod mechanics/lang/command/raco main)
     "show programs typeset; worksheets and classes; a prompt; help" #f)))
