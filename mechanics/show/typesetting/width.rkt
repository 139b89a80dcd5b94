#lang racket/base
;; How many columns a formula takes when it is drawn: as text, whose characters are all as wide, or
;; in type, where a column is 0.46 em, about a small letter.

(require "../../algebra/notation/name.rkt" "../../algebra/notation/tree.rkt")

(provide make-meter)

;; Columns: letter, of a variable of one letter or a digit; index, of a small letter above or below;
;; others, of signs and gaps between the parts of a formula or around them.
(struct scale (letter index term factor comma parentheses bar relation))
(define of-text (scale 1 1 3 1 2 2 2 3))
(define of-type (scale 1.1 0.7 2.5 0.4 0.9 1.5 0.5 2.6))

;; -> (tree -> columns), which looks at each tree once
(define (make-meter typeset?)
  (define known (make-hasheq))
  (define s (if typeset? of-type of-text))
  (define (wide t) (hash-ref! known t (lambda () (measure t wide s))))
  wide)

(define (total wide ts [gap 0])
  (+ (* gap (max 0 (- (length ts) 1))) (for/sum ([t (in-list ts)]) (wide t))))

(define (widest wide ts) (apply max 0 (map wide ts)))

(define (measure t wide s)
  (cond [(name? t) (name-width (name-parts (name-symbol t)) s)]
        [(word? t) (string-length (word-text t))]
        [(digits? t) (* (scale-letter s) (string-length (digits-text t)))]
        [(plain? t) (string-length (plain-text t))]
        [(sum? t) (+ (total wide (tree-parts t) (scale-term s))
                     (if (term-negative? (car (sum-terms t))) 1 0))]
        [(product? t) (total wide (tree-parts t) (scale-factor s))]
        [(fraction? t) (+ (scale-bar s) (widest wide (tree-parts t)))]
        [(power? t) (+ (wide (power-base t)) (* (scale-index s) (wide (power-exponent t))))]
        [(application? t)
         (+ (wide (application-function t))
            (total wide (application-arguments t) (scale-comma s))
            (if (application-bare? t) (scale-factor s) (scale-parentheses s)))]
        [(derivative? t) (+ (total wide (tree-parts t)) (marks-width t s))]
        [else (measure-other t wide s)]))

(define (measure-other t wide s)
  (define parts (tree-parts t))
  (cond [(scientific? t) (+ 6 (string-length (scientific-digits t)))]
        [(omitted? t) (string-length (omitted-count t))]
        [(or (column? t) (broken? t)) (+ 2 (widest wide parts))]
        [(or (across? t) (listing? t)) (+ 2 (total wide parts (scale-comma s)))]
        [(grid? t) (+ 2 (grid-width t wide))]
        [(relation? t) (total wide parts (scale-relation s))]
        [(report? t)
         (define (line-width l)
           (+ (* 2 (report-line-depth l)) (string-length (report-line-label l)) 1
              (total wide (report-line-parts l) 1)))
         (widest line-width (report-lines t))]
        [(row? t) (total wide parts)]
        [else (+ (scale-parentheses s) (total wide parts))]))

(define (name-width p s)
  (define base (string-length (parts-base p)))
  (+ (if (= base 1) (scale-letter s) base)
     (* (scale-index s)
        (+ (string-length (parts-digits p))
           (for/sum ([m (in-list (parts-marks p))]) (string-length (cdr m)))))))

(define (marks-width t s)
  (for/sum ([m (in-list (derivative-marks t))])
    (+ 1 (* (scale-index s)
            (+ (* 2 (length (or (mark-path m) '()))) (if (= 1 (mark-count m)) 0 1))))))

(define (grid-width t wide)
  (define columns (apply map list (grid-rows t)))
  (total (lambda (c) (widest wide c)) columns 2))
