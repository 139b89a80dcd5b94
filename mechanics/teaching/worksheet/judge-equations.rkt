#lang racket/base
;; Equations of motion, up to a factor or a combination.
;;
;; The key's equations M a + b = 0 give the accelerations a of every motion.  An equation of
;; the answer is right if it holds with these, whatever the state: no matter by which factor
;; it was multiplied or to which others it was added.  The answer is right if all of its
;; equations are, and they fix the accelerations as well.  Equations that are true of every motion
;; and fix nothing, as 0 = 0, are trivial.
;;
;; Where an extra factor vanishes, as in (x - 1)(x'' + x) = 0, equations may hold for other motions,
;; too (extra-motions.rkt).  Several that are not linear in the accelerations are left to a person.
;;
;; Where the key's equations do not give the accelerations, the answer's are compared with
;; them one by one.

(require (only-in racket/list count)
         "answer-parts.rkt" "exercise.rkt" "extra-motions.rkt" "judgment.rkt"
         "prescribed-symbols.rkt"
         "../../error/message-words.rkt"
         "../../generic/arithmetic.rkt"
         "../../lagrangian/total-derivative.rkt"
         "../../question/on-demand.rkt"
         "../../value/matrix/linear-algebra.rkt" "../../value/matrix/matrix.rkt"
         "../../value/shape.rkt" "../../value/simplify.rkt" "../../value/structure.rkt"
         "../../verdict/prove-zero.rkt" "../../verdict/verdict.rkt")

(provide judge-equations judge-Lagrangian accelerations-by)

(define (judge-equations e key answer)
  (define names (exercise-coordinates e))
  (judge-residuals names (along-path->symbols key names) (along-path->symbols answer names)))

;; key, answer : in symbols of the long tuple
(define (judge-residuals names key answer)
  (define-values (n m) (values (shape-length key) (shape-length answer)))
  (cond [(not (= n m))
         (wrong #f (format "the answer has ~a, and the question ~a"
                           (counted m "equation") (counted n "equation")))]
        [else
         (define a (accelerations-by key names))
         (if a
             (judge-along-motions names a n key answer)
             (judge-one-by-one key answer names))]))

(define (judge-along-motions names a n key answer)
  (define M (mass-matrix-of answer names))
  (define v
    (prove-zero (as-one (scalars (along-motion answer a names)))
                #:variables (scalars (long-tuple-of names))))
  (cond [(refuted? v) (judge-those-that-hold names M n v)]
        [(not (proved? v)) (undecided-judgment v)]
        [(all-zero? M)
         (trivial v "it is true of every motion, and says nothing about the accelerations")]
        [(not (free-of-accelerations? M names))
         (if (= n 1)
             (judge-extra v 1 (extra-motion names M (g:/ answer key) a) not-linear)
             (undecided-judgment #f not-linear "so other motions may obey it as well"))]
        [(= n (rank M))
         (define ratio (g:/ (determinant M) (determinant (mass-matrix-of key names))))
         (judge-extra v n (extra-motion names M ratio a) #f)]
        [else (partly (/ (rank M) n) v "some of the equations say the same as others")]))

(define not-linear "every motion obeys it, but it is not linear in the accelerations")

;; found : of extra-motion; unclear : words where that is undecided, or #f where the doubt is none
(define (judge-extra v n found unclear)
  (cond [(string? found)
         (partly (- 1 (/ 1 2 n)) v
                 (string-append "it is true of every motion, but it also holds " found))]
        [(and found unclear) (undecided-judgment #f unclear)]
        [else (right v)]))

;; Some equations do not hold.  The others count, as far as they are independent.
(define (judge-those-that-hold names M n v)
  (define hold
    (for/list ([e (in-list (scalars (verdict-residual v)))] [i (in-naturals)]
               #:when (proved? (prove-zero e)))
      (for/list ([j (in-range (m:num-cols M))]) (matrix-ref M i j))))
  (define those (and (pair? hold) (apply matrix-by-rows hold)))
  (cond [(or (not those) (all-zero? those)) (wrong v)]
        [(free-of-accelerations? those names) (partly (/ (rank those) n) v)]
        [else
         (undecided-judgment v (string-append "some of the equations are refuted, and one that "
                                              "holds is not linear in the accelerations"))]))

;; Is each equation a multiple of the key's equation in its place?
(define (judge-one-by-one key answer names)
  (define-values (ks xs) (values (scalars key) (scalars answer)))
  (define v (verify-equal (as-one xs) (as-one ks)))
  (define share (/ (count (lambda (k x) (multiple? k x names)) ks xs) (length ks)))
  (if (= share 1)
      (right v)
      (judged-by v (lambda (_) share))))

(define (multiple? k x names)
  (or (same? k x)
      (and (not (zero-value? k))
           (let ([ratio (simplify (g:/ x k))])
             (and (not (zero-value? ratio))
                  (free-of? ratio (scalars (long-tuple-of names))))))))

;; Does the expression change with none of the symbols?
(define (free-of? e symbols)
  (for/and ([s (in-list symbols)]) (zero-value? (rate e s))))

;; ---------------------------------------------------------------------------
;; M a + b

(define (acceleration-symbols names) (scalars (ref (long-tuple-of names) 3)))

(define (mass-matrix-of E names)
  (apply matrix-by-rows
         (for/list ([e (in-list (scalars E))])
           (for/list ([a (in-list (acceleration-symbols names))]) (simplify (rate e a))))))

(define (every-element? M wanted?)
  (for*/and ([i (in-range (m:num-rows M))] [j (in-range (m:num-cols M))])
    (wanted? (matrix-ref M i j))))

(define (all-zero? M) (every-element? M zero-value?))

;; Are the equations linear in the accelerations?
(define (free-of-accelerations? M names)
  (every-element? M (lambda (e) (free-of? e (acceleration-symbols names)))))

;; E with the list a in place of the accelerations.
(define (along-motion E a names)
  (replace E (map cons (acceleration-symbols names) a)))

;; The accelerations that follow from E = 0, a list; or #f if none follow, or E is not linear in
;; them.
(define (accelerations-by E names)
  (define M (mass-matrix-of E names))
  (define symbols (acceleration-symbols names))
  (and (free-of-accelerations? M names)
       (= (m:num-rows M) (length symbols))
       (not (zero-value? (determinant M)))
       (let ([b (list->up (scalars (along-motion E (map (lambda (_) 0) symbols) names)))])
         (map simplify (scalars (g:negate (solve-linear-left M b)))))))

;; ---------------------------------------------------------------------------
;; Lagrangians

;; Lagrange's equations of L, an expression at the local tuple.
(define (Lagrangian-residual L names)
  ((Euler-Lagrange-operator (value-function L (local-tuple-of names))) (long-tuple-of names)))

;; Up to a factor and a total time derivative, or any change that leaves the equations equivalent.
(define (judge-Lagrangian e key answer)
  (define names (exercise-coordinates e))
  (define local (local-tuple-of names))
  (define (residual L) (Lagrangian-residual L names))
  (define found
    (if (= 1 (shape-length answer))
        (judge-residuals names (residual key) (residual answer))
        (wrong #f "a Lagrangian has a single number as its value")))
  (case (judgment-status found)
    [(right)
     (define v (verify-equivalent-Lagrangians (value-function key local)
                                              (value-function answer local) local))
     (judged-by v (lambda (_) 0))]
    [(trivial)
     (trivial (judgment-verdict found)
              "its equations of motion are 0 = 0: it is a total time derivative")]
    [else found]))
