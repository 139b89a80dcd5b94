#lang racket/base
;; Certificates of verdicts, loaded when they are first asked for.

(require "../generic/on-demand.rkt")

(provide-on-demand ["certificate.rkt" certificate write-certificate])
