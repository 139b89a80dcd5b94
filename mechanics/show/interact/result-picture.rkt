#lang racket/base
(provide convert-outcome)
(define (convert-outcome o request default) default)
