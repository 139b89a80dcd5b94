#lang racket/base
;; Tables in files and motions fitted to data, loaded when they are first used.

(require "../../generic/on-demand.rkt")

(provide-on-demand
 ["write-table.rkt" write-table]
 ["read-table.rkt" read-table]
 ["number-table.rkt" number-table? table-names table-length table-column table-rows]
 ["motion-fit.rkt" motion-fit? motion-fit-values motion-fit-deviations motion-fit-covariance
                   motion-fit-residuals motion-fit-start motion-fit-parameters
                   motion-fit-chi-square]
 ["fit-motion.rkt" fit-motion])
