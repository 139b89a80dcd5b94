#lang racket/base
;; A total time derivative as a theorem: a function of the time and the coordinates whose rate along
;; every path is the function in question, or the difference of two Lagrangians.
;;
;; The function is found again here; Coq checks that its rate is what it is to be.

(require racket/list racket/string
         "Coq-names.rkt" "Coq-term.rkt" "derivative-theorem.rkt" "example-point.rkt"
         "theorem-text.rkt"
         "../error/refusal.rkt"
         "../generic/arithmetic.rkt"
         "../lagrangian/local-tuple.rkt"
         "../question/gauge.rkt"
         (only-in "../value/structure.rkt" s:length)
         (only-in "../verdict/verdict.rkt" gauge-claim-first gauge-claim-second gauge-claim-factor
                  gauge-claim-local))

(provide gauge-theorem)

;; t, xs, vs : the symbols of the local tuple
;; parts     : ((name . expression) ...), of one function or of two Lagrangians
;; factor    : of the first of two
;; f         : expression, whose rate it is
(struct gauge (t xs vs parts factor f) #:authentic)

;; c : gauge-claim; assumed : datums of relations
(define (gauge-theorem c assumed)
  (define M (gauge-of c))
  (define f (list (gauge-f M)))
  (define asked (cons (gauge-factor M) (map cdr (gauge-parts M))))
  (define es (append f asked))
  (define own (all-hypotheses assumed (open-relations asked f)))
  (define found (relations-beyond own (open-relations f '())))
  (define relations (append own found))
  (define ns
    (make-names (append es (append-map relation-sides relations) (symbols-of M))
                (append '("s" "gauge") (map car (gauge-parts M)) (paths M))))
  (define along (names-on-paths ns (gauge-t M) (append (gauge-xs M) (gauge-vs M)) (paths M)
                                relations es))
  (theorem-with-found (string-append (hypotheses-text assumed relations ns found)
                                     (definitions M ns)
                                     (statement M ns along)
                                     (proof M es relations ns along)
                                     (example M relations ns along))
                      relations found ns))

(define (gauge-of c)
  (define-values (first second local)
    (values (gauge-claim-first c) (gauge-claim-second c) (gauge-claim-local c)))
  (unless (= 3 (s:length local)) (give-up "it is a function of accelerations"))
  (define (number f) (car (scalars-in (f local))))
  (define-values (parts factor F)
    (if first
        (values (list (cons "L_1" (number first)) (cons "L_2" (number second)))
                (car (scalars-in (gauge-claim-factor c)))
                (g:- second (g:* (gauge-claim-factor c) first)))
        (values (list (cons "F" (number second))) 0 second)))
  (define f
    (with-handlers ([refusal?
                     (lambda (_) (give-up "no formula was found of which it is the rate"))])
      ((gauge-function F local) local)))
  (gauge (time local) (scalars-in (coordinate local)) (scalars-in (velocity local))
         parts factor (car (scalars-in f))))

(define (symbols-of M) (cons (gauge-t M) (append (gauge-xs M) (gauge-vs M))))
(define (count-of M) (length (gauge-xs M)))
(define (positions M) (numbered "path" (count-of M)))
(define (velocities M) (numbered "velocity" (count-of M)))
(define (paths M) (append (positions M) (velocities M)))

;; ---------------------------------------------------------------------------
;; The text

(define (definitions M ns)
  (define parts (gauge-parts M))
  (string-join
   (append
    (list "Section gauge." (parameters-text ns (symbols-of M)))
    (definition-lines (if (null? (cdr parts))
                          "Of the time, the coordinates and the velocities"
                          "The Lagrangians")
                      (map car parts) (symbols-of M) (map cdr parts) ns)
    (definition-lines "The function whose rate it is, the theorem says" '("gauge")
                      (cons (gauge-t M) (gauge-xs M)) (list (gauge-f M)) ns)
    '("" ""))
   "\n"))

(define (statement M ns along)
  (define t (name-of ns (gauge-t M)))
  (define state (string-join (cons t (at (paths M) t)) " "))
  (format (string-append "Theorem claim : forall (~a : R -> R) (~a : R),\n  hypotheses ~a ->\n"
                         "  ~a ->\n  ~a.\n")
          (string-join (paths M) " ") t (wrapped (string-join (all-names along) " "))
          (string-join (moves M t) " ->\n  ")
          (wrapped
           (format "is_derive (fun s => gauge ~a) ~a (~a)"
                   (string-join (cons "s" (at (positions M) "s")) " ") t
                   (cond [(null? (cdr (gauge-parts M))) (format "F ~a" state)]
                         [(eqv? 1 (gauge-factor M)) (format "L_2 ~a - L_1 ~a" state state)]
                         [else (format "L_2 ~a - ~a * L_1 ~a" state
                                       (term (gauge-factor M) ns 2) state)])))))

(define (moves M t)
  (for/list ([x (in-list (positions M))] [v (in-list (velocities M))])
    (format "is_derive ~a ~a (~a ~a)" x t v t)))

(define (proof M es relations ns along)
  (define-values (lines tactic) (known-lines es relations along))
  (format "Proof.\n  unfold hypotheses. intros ~a ~a ~a ~a.\n~a  unfold gauge, ~a.\n  ~a.\n~a"
          (string-join (paths M) " ") (name-of ns (gauge-t M)) (given-pattern (length relations))
          (string-join (numbered-from-1 "moves" (count-of M))) lines
          (string-join (map car (gauge-parts M)) ", ")
          (derivative-proof tactic along)
          "Qed.\nEnd gauge.\n\n"))

;; Straight paths through a point where the hypotheses hold
(define (example M relations ns along)
  (define values (example-values relations ns))
  (define own (names-without ns (append (gauge-xs M) (gauge-vs M))))
  (define t (name-of ns (gauge-t M)))
  (define there
    (string-join (for*/list ([base (in-list '("place" "speed"))]
                             [name (in-list (numbered-from-1 base (count-of M)))])
                   (string-append "?" name))
                 ", "))
  (format (string-append "Theorem not_vacuous : exists ~a (~a : R -> R),\n  ~a /\\\n  ~a.\n"
                         "Proof.\n~a  exists ~a, ~a.\n  split.\n"
                         "  { rewrite ~a. unfold hypotheses. cbv beta.\n~a  }\n"
                         "  ~a; rewrite ~a; assumption.\n"
                         "Qed.\n\n")
          (binders own) (string-join (paths M) " ")
          (wrapped (format "hypotheses ~a" (string-join (all-names along) " ")))
          (conjunction (moves M t))
          (through-text M values ns)
          (wrapped (string-join (witness-texts values own) ", ")) (string-join (paths M) ", ")
          there
          (example-steps relations values ns)
          (refine-text (count-of M)) there))

(define (through-text M values ns)
  (define (number s) (value-text s (cdr (assoc s values)) ns))
  (paths-through (map number (gauge-xs M)) (map number (gauge-vs M)) (make-list (count-of M) "0")
                 (number (gauge-t M)) (positions M) (velocities M)))
