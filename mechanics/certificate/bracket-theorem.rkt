#lang racket/base
;; A canonical transformation as a theorem: with the derivatives of the old coordinates and momenta
;; by the new ones, which Coq checks, all Poisson brackets are what they are to be.
;;
;; D1_momentum_0 is the derivative of momentum_0 by its argument 1, where argument 0 is the time.

(require racket/list racket/string
         "Coq-names.rkt" "derivative-theorem.rkt" "theorem-text.rkt"
         "../calculus/derivative.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt"
         (only-in "../verdict/verdict.rkt" canonical-claim-C canonical-claim-clock?
                  canonical-claim-state))

(provide bracket-theorem)

;; arguments : the symbols of the state, n coordinates among them
;; names, es : of the old coordinates and momenta
;; slopes    : for each of them ((name . expression) ...), its derivatives by arguments 1 ... 2n
;; clock     : the old time in a list; none if it is the new one, or not judged
(struct transformation (arguments n names es slopes clock) #:authentic)

;; c : canonical-claim; assumed : datums of relations
(define (bracket-theorem c assumed)
  (define M (transformation-of c))
  (define slopes (append* (map (lambda (row) (map cdr row)) (transformation-slopes M))))
  (define mapped (append (transformation-es M) (transformation-clock M)))
  (define all (append mapped slopes))
  (define domain (open-relations all mapped))
  (define relations (all-hypotheses assumed domain))
  (define ns
    (make-names (append all (append-map relation-sides relations) (transformation-arguments M))
                (cons "s" (names-defined M))))
  (define-values (lines tactic) (known-lines all relations ns))
  (theorem (string-append (hypotheses-text assumed relations ns)
                          (definitions M ns)
                          (statement M ns)
                          (proof M ns lines tactic (given-pattern (length relations)))
                          (example-text relations ns))
           (hypothesis-texts relations ns)
           '()))

(define (transformation-of c)
  (define-values (C state) (values (canonical-claim-C c) (canonical-claim-state c)))
  (define old (C state))
  (define n (shape-length (coordinate state)))
  (define names (append (numbered "coordinate" n) (numbered "momentum" n)))
  (define (by k) (cdr (scalars-in ((derivative-by C k) state))))
  (define columns (for/list ([k (in-range (* 2 n))]) (by k)))
  (transformation (scalars-in state) n names (cdr (scalars-in old))
                  (for/list ([name (in-list names)] [i (in-naturals)])
                    (for/list ([column (in-list columns)] [k (in-naturals 1)])
                      (cons (format "D~a_~a" k name) (list-ref column i))))
                  (if (and (canonical-claim-clock? c) (not (equal? (time old) (time state))))
                      (list (time old))
                      '())))

;; The derivative of C by the coordinate or momentum of that place
(define ((derivative-by C k) state)
  (define direction (list-set (map (lambda (_) 0) (scalars-in state)) (+ k 1) 1))
  (define-values (_ slope)
    (value-and-derivative-along C state (list->structure state direction)))
  slope)

(define (clock-names M) (map (lambda (_) "time") (transformation-clock M)))

(define (names-defined M)
  (append (clock-names M)
          (transformation-names M)
          (append-map (lambda (row) (map car row)) (transformation-slopes M))))

;; ---------------------------------------------------------------------------
;; The text

(define (definitions M ns)
  (define arguments (transformation-arguments M))
  (define (each comment names es) (definition-lines comment names arguments es ns))
  (define slopes (append* (transformation-slopes M)))
  (string-join
   (append (list "Section transformation." (parameters-text ns arguments))
           (each "The old coordinates and momenta, by the new ones"
                 (append (clock-names M) (transformation-names M))
                 (append (transformation-clock M) (transformation-es M)))
           (each "and, the theorem says, their derivatives" (map car slopes) (map cdr slopes))
           '("" ""))
   "\n"))

(define (arguments-text M ns)
  (string-join (for/list ([a (in-list (transformation-arguments M))]) (name-of ns a)) " "))

(define (claims M ns)
  (define arguments (for/list ([a (in-list (transformation-arguments M))]) (name-of ns a)))
  (append
   (for*/list ([name (in-list (clock-names M))] [k (in-range (length arguments))])
     (derivative-text name arguments k (if (= k 0) "1" "0")))
   (for*/list ([(name row) (in-parallel (transformation-names M) (transformation-slopes M))]
               [(slope k) (in-parallel row (in-naturals 1))])
     (derivative-text name arguments k (string-join (cons (car slope) arguments) " ")))
   (brackets M ns)))

;; Σ ∂zᵢ/∂q ∂zⱼ/∂p - ∂zᵢ/∂p ∂zⱼ/∂q, of each pair
(define (brackets M ns)
  (define n (transformation-n M))
  (define rows (transformation-slopes M))
  (define (slope i k) (format "~a ~a" (car (list-ref (list-ref rows i) k)) (arguments-text M ns)))
  (for*/list ([i (in-range (* 2 n))] [j (in-range (+ i 1) (* 2 n))])
    (format "~a = ~a"
            (string-join (for/list ([k (in-range n)])
                           (format "~a * ~a - ~a * ~a" (slope i k) (slope j (+ k n))
                                   (slope i (+ k n)) (slope j k)))
                         " + ")
            (if (= j (+ i n)) 1 0))))

(define (statement M ns)
  (format "Theorem claim : forall ~a : R,\n  hypotheses ~a ->\n  ~a.\n"
          (arguments-text M ns) (wrapped (string-join (all-names ns) " "))
          (conjunction (claims M ns))))

(define (proof M ns lines tactic given)
  (format (string-append "Proof.\n  unfold hypotheses. intros ~a ~a.\n~a  unfold ~a.\n"
                         "  ~a;\n  first [~a | ~a].\n~a")
          (arguments-text M ns) given lines
          (wrapped (string-join (names-defined M) ", "))
          (refine-text (length (claims M ns)))
          (derivative-proof tactic ns) tactic
          "Qed.\nEnd transformation.\n\n"))
