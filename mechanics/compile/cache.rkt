#lang racket/base
;; Compiled programs, kept for when the same one is asked for again.
;;
;; A program is its own key: it says all there is to know about the code, so
;; that nothing stale can be served.  The last few are kept.

(require racket/list
         "tiers.rkt")

(provide (protect-out compiled-program) clear-compiled-programs compiled-program-count)

(define capacity 32)

;; ((program . maker) ...), the latest first
(define cache (box '()))

(define (clear-compiled-programs) (set-box! cache '()))

;; How many are kept.
(define (compiled-program-count) (length (unbox cache)))

(define (compiled-program p)
  (define known (assoc p (unbox cache)))
  (cond [known (cdr known)]
        [else
         (define maker (program->tiered-maker p))
         (remember p maker)
         maker]))

(define (remember p maker)
  (define old (unbox cache))
  (define kept (if (< (length old) capacity) old (take old (- capacity 1))))
  (define new (cons (cons p maker) kept))
  (unless (box-cas! cache old new) (remember p maker)))
