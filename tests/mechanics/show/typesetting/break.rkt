#lang racket/base
;; Formulas cut into lines: commas at the ends of lines, no product in scraps, the width of type.

(require (only-in racket/list remove-duplicates)
         racket/string
         mechanics
         (prefix-in t: "../../../../mechanics/algebra/notation/tree.rkt")
         (only-in "../../../../mechanics/generic/value-tree.rkt" value->tree)
         "../../../../mechanics/show/typesetting/TeX.rkt"
         "../../../../mechanics/show/typesetting/break.rkt"
         "../../../../mechanics/show/typesetting/drawn-text.rkt"
         (only-in "../../../../mechanics/show/typesetting/text-box.rkt" columns-wide)
         "../../../../mechanics/show/typesetting/width.rkt"
         "../../../../mechanics/show/typesetting/MathML.rkt"
         "../../support/checks.rkt" "../../support/golden/values.rkt")

(define (sum-of name n) (apply + (for/list ([i n]) (string->symbol (format "~a_~a" name i)))))

;; Trees in it, of a sort.
(define (parts-of-sort t sort?)
  (define below (for/list ([part (t:tree-parts t)]) (parts-of-sort part sort?)))
  (apply append (if (sort? t) (list t) '()) below))

(test-case "a comma stands at the end of the last line of what it follows"
  (define text (tree->text (fit (value->tree (down (sum-of 'alpha 12) 'y) #t) 30)))
  (define with-comma (filter (lambda (line) (string-contains? line ",")) (string-split text "\n")))
  (check-equal? (length with-comma) 1)
  (check-regexp-match #rx"α₁₁," (car with-comma)))

(define (pendulum-term) (* 'l_1 'l_2 'm_2 (cos (- 'theta_1 'theta_2)) 'thetadot_2))

(test-case "a function that fits on a line is not cut within"
  (define cut (fit (value->tree (* 'amplitude 'm (cos (- 'theta_1 'theta_2 'theta_3)) 'b) #t) 30))
  (check-equal? (length (parts-of-sort cut t:broken?)) 1)
  (check-false (ormap (lambda (a) (pair? (parts-of-sort a t:broken?)))
                      (parts-of-sort cut t:application?))))

(test-case "a short factor stands beside the long one that is cut"
  (define t (value->tree (* 'm_2 (sum-of 'beta 12) (sin (- 'theta_1 'theta_2))) #t))
  (define cut (fit t 24))
  (check-regexp-match #px"^\\\\begin[{]aligned[}]&m_[{]2[}]\\\\,\\\\left[(]" (tree->TeX cut))
  (for ([part (parts-of-sort cut t:product?)])
    (check-true (> (length (t:product-factors part)) 1))))

(test-case "type is narrower than text where there are indices, and no wider elsewhere"
  (define t (value->tree (pendulum-term) #t))
  (define (columns typeset?) ((make-meter typeset?) t))
  (check-true (< (* 0.6 (columns #f)) (columns #t) (* 0.9 (columns #f))))
  (check-equal? (fit t 22 #:typeset? #t) t)
  (check-not-equal? (fit t 22) t))

(test-case "signs and gaps are no wider in type than in text"
  (define (between t typeset?)
    (define wide (make-meter typeset?))
    (apply - (wide t) (map wide (t:tree-parts t))))
  (define-values (a b) (values (value->tree 'alpha #t) (value->tree 'beta #t)))
  (for ([t (list (t:relation a "=" b) (value->tree (+ 'alpha 'beta) #t)
                 (value->tree (* 'alpha 'beta) #t) (value->tree (cos 'alpha) #t))])
    (check-true (< 0 (between t #t) (between t #f)))))

(define ((L-spring m k) local)
  (- (* 1/2 m (square (velocity local))) (* 1/2 k (square (coordinate local)))))

;; Columns of the longest line.
(define (longest t)
  (apply max 0 (map columns-wide (string-split (tree->text t) "\n" #:trim? #f))))

(test-case "as text a formula is as wide as it is drawn"
  (define wide (make-meter #f))
  (for ([x (list 'a 'ab 'abc 'theta_1 'omega_12 12 3/7 1.5 (+ 'a 'b) (- 'b 'a) (- (+ 'a 'b))
                 (* 'a (+ 'c 'd)) (/ 'a 'b) (expt 'x 2) (expt 'x -2) (sin 'theta) (atan 'y 'x)
                 (cos (+ 'theta 'phi)) ((literal-function 'f) 'x)
                 (((expt D 4) (literal-function 'f)) 't)
                 (up) (up 'a 'b) (down) (down 'x) (down 'a 'b)
                 (down 'a 'b 'c) (matrix-by-rows (list 1 'a) (list 0 (/ 1 'b)))
                 (equilibrium-stability (L-spring 'm 'k) 0))])
    (define t (value->tree x #t))
    (check-equal? (wide t) (longest t) (tree->text t))))

;; A function is cut between its parentheses where it would not fit by itself.
(test-case "functions and products with functions keep to the width"
  (define (f n) ((literal-function 'f) (sum-of 'alpha n)))
  (for* ([n '(2 3 4 6 12)] [t (list (f n) (* 'b_1 (f n)))] [width (in-range 20 60)])
    (check-true (<= (longest (fit (value->tree t #t) width)) width) (format "~a ~a" n width))))

(test-case "one long factor is cut within where the others leave it half a line"
  (define (cut width)
    (fit (value->tree (* 'amplitude 'moment (sum-of 'beta 12)) #t) width))
  (check-pred t:product? (cut 40))
  (check-pred t:broken? (cut 30)))

(test-case "every formula can be cut for type of any width"
  (for* ([entry values-to-typeset] [width '(1 13 24 41 60)])
    (define t (value->tree (cdr entry) #t))
    (check-pred string? (tree->MathML (fit t width #:typeset? #t) #t) (car entry))))

(test-case "a long factor keeps most of a line"
  (define t (value->tree (* (sum-of 'beta 40) (sqrt (+ 1 'y)) (cos 'alpha) (sin 'omega)) #t))
  (for ([line (cdr (string-split (tree->text (fit t 40)) "\n"))])
    (check-true (<= (string-length line) 42))))

;; The brackets take two columns, what stands beside an entry two more.
(test-case "entries of a matrix share the width among its columns"
  (define entry (sum-of 'beta 24))
  (define (entries columns width)
    (define M (apply matrix-by-rows (for/list ([_ 2]) (for/list ([_ columns]) entry))))
    (define grid (car (parts-of-sort (fit (value->tree M #t) width) t:grid?)))
    (remove-duplicates (apply append (t:grid-rows grid))))
  (define (alone width) (list (fit (value->tree entry #t) width)))
  (check-equal? (entries 1 30) (alone 26))
  (check-equal? (entries 2 58) (alone 26))
  (check-equal? (entries 3 86) (alone 26)))

(test-case "both sides of a long relation stay within the width"
  (define t (t:relation (value->tree (sum-of 'alpha 12) #t) "=" (value->tree (sum-of 'beta 24) #t)))
  (for ([width (in-range 24 60)])
    (define lines (string-split (tree->text (fit t width)) "\n"))
    (check-true (<= (apply max (map string-length lines)) width) (format "~a" width))
    (check-true (<= (length lines) (+ 4 (quotient 220 (- width 8)))) (format "~a" width))))
