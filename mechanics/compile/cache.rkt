#lang racket/base
;; Compiled programs, kept for when the same one is asked for again.
;;
;; A program is its own key: it says all there is to know about the code, so
;; that nothing stale can be served.  The last few are kept.

(require racket/list
         "tiers.rkt")

(provide (protect-out compiled-program) made-of-program
         clear-compiled-programs compiled-program-count)

(define capacity 32)

;; made : values that others have made of the program, by name
(struct entry (program maker [made #:mutable]) #:authentic)

;; list of entries, the latest first
(define cache (box '()))

(define (clear-compiled-programs) (set-box! cache '()))

;; How many are kept.
(define (compiled-program-count) (length (unbox cache)))

(define (compiled-program p)
  (define known (entry-of p))
  (cond [known (entry-maker known)]
        [else
         (define maker (program->tiered-maker p))
         (remember (entry p maker (hasheq)))
         maker]))

(define (entry-of p)
  (for/first ([e (in-list (unbox cache))] #:when (equal? p (entry-program e))) e))

(define (remember e)
  (define old (unbox cache))
  (define kept (if (< (length old) capacity) old (take old (- capacity 1))))
  (unless (box-cas! cache old (cons e kept)) (remember e)))

;; The value of (make) for a program, kept under a name as long as the program is.
(define (made-of-program p name make)
  (define e (entry-of p))
  (define (make-and-keep)
    (define new (make))
    (set-entry-made! e (hash-set (entry-made e) name new))
    new)
  (if e (hash-ref (entry-made e) name make-and-keep) (make)))
