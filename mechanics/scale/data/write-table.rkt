#lang racket/base
;; Tables written to files: trajectories, branches, sections, ensembles, row after row.

(require "CSV.rkt" "NPY.rkt" "NPZ.rkt" "table-format.rkt" "written-rows.rkt"
         "../../generic/define-plain.rkt" "../../generic/output-file.rkt")

(provide write-table)

(define who 'write-table)

;; data : a trajectory, a branch, a table, or a sequence of states and other rows, taken one by one
(define-plain (write-table data file #:names [names #f] #:times [times #f])
  (define format (table-format who file))
  (check-file who file)
  (define-values (columns next) (rows-of data names times))
  (call-writing-file
   who file
   (lambda (port)
     (case format
       [(CSV) (write-CSV columns next port)]
       [(NPY) (write-NPY columns next port)]
       [(NPZ) (write-NPZ who columns next port)]))))
