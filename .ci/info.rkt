#lang info
;; Tools of those who work on the library.
(define compile-omit-paths 'all)
