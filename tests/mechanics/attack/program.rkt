#lang racket/base
;; A wrong claim as a program that can be pasted, with what is wrong as comments.

(require racket/format racket/pretty
         "claims.rkt" "judge/fault.rkt" "classes/motions.rkt" "statement.rkt")

(provide program-text)

(define (program-text o)
  (string-append (comments o) "#lang mechanics\n" (program-of o)))

(define (comments o)
  (define f (outcome-judgement o))
  (if (fault? f)
      (string-append
       (format "; ~a, yet ~a~a\n" (outcome-answer o) (words-of (fault-kind f)) (detail-text o))
       (if (fault-numbers f) (format "; at ~a\n" (numbers-text (fault-numbers f))) "")
       (if (fault-left f)
           (format "; the left side is ~a, the right side ~a\n"
                   (shown (fault-left f)) (shown (fault-right f)))
           ""))
      (format "; ~a\n" (outcome-answer o))))

(define (words-of kind)
  (case kind
    [(values-differ) "the values differ"]
    [(assumptions-hold-nowhere) "what is assumed holds at no point tried of the question"]
    [(nowhere-defined) "no point has a value on both sides"]
    [(result-nowhere-defined) "the result has no value where the question has one"]
    [(no-value-at-witness) "a side has no real value at the witness"]
    [(witness-outside-given) "what is declared does not hold at the witness"]
    [(no-difference-at-witness) "both sides are equal at the witness"]
    [(function-of-two-values) "a function has two values at one argument"]
    [(opposites-proved) "so is the opposite, and the right side is not zero"]
    [(not-smooth) "the path, or what it is about, is not smooth"]
    [(residual) "the residual says otherwise"]
    [(no-integral) "there is no integral"]
    [(motions-differ) "the motions are others, or not all of them conserve it"]
    [else (~a kind)]))

(define (detail-text o)
  (define d (outcome-detail o))
  (cond [(not d) ""]
        [(memq (outcome-answer o) '(form found))
         (format "\n;   ~s~a" (car d) (if (null? (cdr d)) "" (format ", assuming ~s" (cdr d))))]
        [(null? d) ""]
        [else (format "\n;   ~s" d)]))

(define (numbers-text numbers)
  (apply string-append
         (for/list ([(s x) (in-hash numbers)] [i (in-naturals)])
           (format "~a~a = ~a" (if (eqv? i 0) "" ", ") s x))))

(define (shown v)
  (cond [(and (real? v) (exact? v) (not (integer? v))) (exact->inexact v)]
        [(not v) "none"]
        [else v]))

;; ---------------------------------------------------------------------------
;; Programs

(define (program-of o)
  (define s (outcome-subject o))
  (define forms
    (cond [(proposal? s) (motion-program s)]
          [(inquiry? s) (list (inquiry-program s))]
          [else (statement-program s (outcome-claim o))]))
  (apply string-append
         (for/list ([f (in-list forms)])
           (parameterize ([pretty-print-columns 98])
             (string-append (pretty-format f #:mode 'write) "\n")))))

(define (statement-program s claim)
  (append
   (if (null? (statement-given s))
       '()
       (list (cons 'assume (map quoted (statement-given s)))))
   (list (if (eq? 'form claim)
             `(simplify ,(written (statement-left s)))
             `(prove-zero (- ,(written (statement-left s)) ,(written (statement-right s))))))))

(define (motion-program p)
  (define V
    (case (proposal-force p)
      [(none) 0]
      [(constant) '(coordinate s)]
      [else '(* 1/2 (square (coordinate s)))]))
  (list `(verify-solution
          (lambda (s) (- (* 1/2 (square (velocity s))) ,V))
          (lambda (t) ,(proposal-path p)))))

(define (quoted x) (list 'quote x))

;; The expression that makes it: symbols quoted, literal functions made.
(define (written e)
  (cond [(symbol? e) (quoted e)]
        [(pair? e) (cons (written-head (car e) (length (cdr e))) (map written (cdr e)))]
        [else e]))

(define (written-head head arity)
  (define (literal name)
    (if (eqv? arity 1)
        `(literal-function ',name)
        `(literal-function ',name (-> (X Real Real) Real))))
  (cond [(pair? head) (list (car head) (literal (cadr head)))]
        [(memq head '(V W F)) (literal head)]
        [else head]))
