#lang s-exp syntax/module-reader
;; `#lang mechanics` is read, coloured and indented as Racket is.
mechanics
