#lang info
;; What only those who work on the library need.
(define compile-omit-paths 'all)
