#lang racket/base
;; Derivations as values: steps with their values, and a verdict on each: was the value found in
;; another way as well, or else, is the shown value equal to the computed one?

(require (only-in racket/list append*)
         (only-in racket/string string-join)
         "../../generic/describe.rkt" "../../generic/notation.rkt" "../../generic/value-struct.rkt"
         "../../value/simplify.rkt"
         "../../verdict/prove-zero.rkt" "../../verdict/verdict.rkt")

(provide (struct-out step) derivation derivation? derivation-lines make-step)

;; label : datum; value : simplified
(struct step (label value verdict) #:authentic)

(define (make-step label value [verdict #f])
  (define shown (simplify value))
  (step label shown (or verdict (verify-equal value shown))))

;; lines : steps
(value-struct derivation (lines)
  #:text derivation->text
  #:notation derivation-notation)

(define (derivation->text d)
  (string-join
   (for/list ([s (in-list (derivation-lines d))])
     (format "~a\n  ~a\n  ~a" (value->text (step-label s)) (value->text (step-value s))
             (string-join (map car (grounds s)) "\n  ")))
   "\n"))

(define (derivation-notation d see)
  (apply statement
         (append*
          (for/list ([s (in-list (derivation-lines d))])
            (cons (list 0 "" (tree:relation (tree:datum (step-label s)) "=" (see (step-value s))))
                  (for/list ([g (in-list (grounds s))])
                    (if (cdr g)
                        (list 1 "assuming" (tree:datum (cdr g)))
                        (list 1 (car g)))))))))

;; The verdict in a word, and its assumptions: (text . datum), #f for the word.
(define (grounds s)
  (define v (step-verdict s))
  (cons (cons (if (proved? v)
                  "proved"
                  (format "~a: it leaves ~a" (verdict-status v) (value->text (verdict-residual v))))
              #f)
        (for/list ([a (in-list (verdict-assumptions v))])
          (cons (format "assuming ~a" (value->text a)) a))))
