#lang racket/base
;; Maps explored in a notebook: the front end shows the picture, and tells where it was clicked.
;;
;; Explorations that were shown are kept under numbers, for their cells may still be on the page.

(require "mime-bundle.rkt"
         "../show/explorer/explored-frame.rkt")

(provide exploration-message explored-answer)

;; number -> exploration
(define shown (make-hasheqv))

;; arguments : as explore-in-window takes them -> message
(define (exploration-message who f map n starts source)
  (define number (hash-count shown))
  (define x (open-explored-frame who f map n starts))
  (hash-set! shown number x)
  (hash-set* (now x) 'kind "exploration" 'number number))

;; actions : lists of an action and its places, as act-on! takes them -> hash of the view then
(define (explored-answer number actions)
  (define x (hash-ref shown number))
  (for ([a (in-list actions)]) (act-on! x (car a) (cdr a)))
  (now x))

(define (now x)
  (define more? (wait-for-points x))
  (hasheq 'data (value->bundle (explored-picture x) (if more? '(svg-bytes) '(svg-bytes png-bytes)))
          'text (explored-text x)
          'more more?))
