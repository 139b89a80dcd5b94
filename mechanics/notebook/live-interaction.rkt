#lang racket/base
;; Interactions in a notebook: the front end shows their controls, and asks for the value where
;; they are moved to.
;;
;; Interactions that were shown are kept under numbers, for their cells may still be on the page.

(require "mime-bundle.rkt"
         "../show/interact/control.rkt" "../show/interact/interaction.rkt"
         "../show/interact/outcome.rkt")

(provide interaction-message frame-bundle)

;; number -> interaction
(define shown (make-hasheqv))

(define (interaction-message i)
  (define number (hash-count shown))
  (hash-set! shown number i)
  (hasheq 'kind "interaction" 'number number
          'controls (map control->json (interaction-controls i))
          'data (outcome->bundle ((interaction-first i)) '(svg-bytes png-bytes))))

;; values : a number, the number of a choice, a boolean or a text for each control
;; -> bundle; a break is raised
(define (frame-bundle number values)
  (define i (hash-ref shown number #f))
  (if i
      (outcome->bundle (interaction-outcome i (check-values i values)) '(svg-bytes))
      (words->bundle "the definitions that this rests on are gone: run its cell again")))

(define (outcome->bundle x formats)
  (if (failed? x) (words->bundle (failed-text x)) (value->bundle x formats)))

(define (control->json c)
  (define start (control-start c))
  (define position (and (control-values c) (control-position c start)))
  (hasheq 'name (symbol->string (control-name c))
          'kind (symbol->string (control-kind c))
          'labels (if (control-values c)
                      (for/list ([v (in-vector (control-values c))]) (value->label v))
                      '())
          'values (if (eq? (control-kind c) 'number)
                      (for/list ([v (in-vector (control-values c))]) (exact->inexact v))
                      '())
          'step (if (control-step c) (exact->inexact (control-step c)) 'null)
          'start (if (eq? (control-kind c) 'text) start position)))
