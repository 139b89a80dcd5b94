#lang racket/base
;; Formulas on one line, as infix.rkt writes them, read back as S-expressions.
;;
;;     relation := sum { (= < > ≤ ≥ ∘ ↦) sum }        sum     := [−] term { (+ −) [−] term }
;;     term     := product { / [−] factor | * [−] product }
;;     product  := factor { [* [−]] factor }
;;     factor   := primary { superscript | ^ power | ( arguments ) }, none but ^ after a space
;;     power    := [−] primary [** power]
;;
;; The signs * and ^ (or **) are not written by infix.rkt where it can do without, but by people.
;; How people type formulas is for handwritten-formula.rkt.

(require "formula-tokens.rkt" "one-line-name.rkt" "read-terms.rkt" "token-reader.rkt"
         "../../error/complain.rkt")

(provide infix->datum)

(define (infix->datum text)
  (define fail (failing-in text))
  (tokens->datum (tokens text fail) fail))

;; all : the tokens of a text; fail : position message -> does not return
(define (tokens->datum all fail)
  (define in (infix-reader all (refusing fail) fail))
  (define d (read-relation in))
  (unless (eq? (kind-ahead in) 'end) (unexpected in))
  d)

;; fail : position message -> does not return
(struct infix-reader reader (fail) #:authentic)

(define (kind-ahead in) (token-kind (ahead in)))

(define ((refusing fail) t)
  (fail (token-at t)
        (case (token-kind t)
          [(end) "it ends here"]
          [(dots) "⋯, which stands for terms that are not written"]
          [else (token-text t)])))

(define ((failing-in text) at what)
  (complain 'read-infix "not a formula on one line\n  at: ~a, position ~a\n  in: ~a"
            what at text))

;; ---------------------------------------------------------------------------
;; Sums and products

(define relation-names
  (hash "=" '= "<" '< ">" '> "≤" '<= "≥" '>= "∘" 'compose))

(define (read-relation in)
  (let loop ([left (read-sum in)])
    (define sign (accept! in 'relation))
    (if sign (loop (related sign left (read-sum in) in)) left)))

(define (related sign left right in)
  (define name (hash-ref relation-names (token-text sign) #f))
  (cond [(not name)
         (or (series->datum left right)
             ((infix-reader-fail in) (token-at sign) "no power series"))]
        [(and (pair? left) (eq? (car left) name) (> (length left) 2))
         (append left (list right))]
        [else (list name left right)]))

(define (read-sum in)
  (let loop ([terms (list (signed in read-term))])
    (cond [(accept! in 'plus) (loop (cons (signed in read-term) terms))]
          [(ahead? in 'minus) (loop (cons (signed in read-term) terms))]
          [else (terms->datum (reverse terms))])))

;; Reads by `read`; behind a minus sign, the negative.
(define (signed in read)
  (if (accept! in 'minus)
      (negative (signed in read))
      (read in)))

(define (read-term in)
  (let loop ([t (read-product in)])
    (cond [(accept! in 'slash) (loop (quotient-of t (signed in read-factor)))]
          [(accept! in 'times) (loop (product-of t (signed in read-product)))]
          [else t])))

(define (product-of a b)
  (append (if (product? a) a (list '* a)) (if (product? b) (cdr b) (list b))))

(define (product? d) (and (pair? d) (eq? (car d) '*)))

(define (read-product in)
  (let loop ([factors (list (read-factor in))])
    (cond [(accept! in 'times) (loop (cons (signed in read-factor) factors))]
          [(memq (kind-ahead in) starts-of-factors)
           (loop (cons (read-factor in) factors))]
          [(null? (cdr factors)) (car factors)]
          [else (cons '* (reverse factors))])))

;; ---------------------------------------------------------------------------
;; Factors

(define starts-of-factors '(number name unit quoted open root bracket partial plain))

(define (read-factor in)
  (if (accept! in 'root)
      (list 'sqrt (read-primary in))
      (let loop ([d (read-primary in)])
        (cond [(glued? in 'raised) (loop (list 'expt d (token-value (take! in))))]
              [(accept! in 'caret) (loop (list 'expt d (read-power in)))]
              [(and (glued? in 'open) (not (number? d))) (loop (cons d (read-arguments in)))]
              [(and (glued? in 'name) (eq? 'i (token-value (ahead in))))
               (take! in)
               (loop (make-rectangular 0 d))]
              [else d]))))

;; x**y**z is x**(y**z), as in Python; of x^y^z other programs make (x^y)^z.
(define (read-power in)
  (signed in (lambda (in)
               (define d (read-primary in))
               (cond [(not (ahead? in 'caret)) d]
                     [(string=? "**" (token-text (ahead in)))
                      (take! in)
                      (list 'expt d (read-power in))]
                     [else (unexpected in)]))))

(define (parenthesized in)
  (expect! in 'open)
  (define d (read-relation in))
  (expect! in 'close)
  d)

(define (read-arguments in)
  (expect! in 'open)
  (define ds (if (ahead? in 'close) '() (separated in 'comma read-relation)))
  (expect! in 'close)
  ds)

;; Reads by `read` once or more, with signs of that kind between.
(define (separated in kind read)
  (let loop ([ds (list (read in))])
    (cond [(accept! in kind) (loop (cons (read in) ds))]
          [else (reverse ds)])))

(define (read-primary in)
  (case (kind-ahead in)
    [(number) (token-value (take! in))]
    [(open) (parenthesized in)]
    [(bracket) (read-matrix in)]
    [(quoted plain) (token-value (take! in))]
    [(unit) (unit-datum (token-text (take! in)))]
    [(partial) (read-derivative in '())]
    [(name) (read-name in)]
    [else (unexpected in)]))

(define (read-name in)
  (define text (token-text (ahead in)))
  (cond [(known-word? text) (read-known (string->symbol text) in)]
        [(string=? text "D") (read-derivative in '())]
        [else (token-value (take! in))]))

;; sin x, sin² x, sin(x + y); a tuple, a list
(define (read-known name in)
  (take! in)
  (define exponent
    (cond [(glued? in 'raised) (token-value (take! in))]
          [(glued? in 'caret) (take! in) (read-power in)]
          [else #f]))
  (define d
    (cond [(glued? in 'open) (cons name (read-arguments in))]
          [(memq (kind-ahead in) '(name number quoted))
           (list name (token-value (take! in)))]
          [else name]))
  (if exponent (list 'expt d exponent) d))

;; D²x, ∂₁∂₀F; the operator itself where nothing follows at once
(define (read-derivative in marks)
  (define sign (take! in))
  (define mark (if (eq? (token-kind sign) 'partial) (cons 'partial (token-value sign)) 'D))
  (define times (if (glued? in 'raised) (token-value (take! in)) 1))
  (define all (append marks (list (if (eqv? times 1) mark (list 'expt mark times)))))
  (define how (if (null? (cdr all)) (car all) (cons '* all)))
  (cond [(or (glued? in 'partial) (and (glued? in 'name) (string=? "D" (token-text (ahead in)))))
         (read-derivative in all)]
        [(glued? in 'open) (list how (parenthesized in))]
        [(or (glued? in 'name) (glued? in 'quoted) (glued? in 'plain))
         (list how (token-value (take! in)))]
        [else how]))

(define (read-matrix in)
  (define (read-row in) (cons 'list (separated in 'comma read-relation)))
  (expect! in 'bracket)
  (define rows (separated in 'semicolon read-row))
  (expect! in 'bracket-close)
  (cons 'matrix-by-rows rows))
