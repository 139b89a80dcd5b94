#lang racket/base
;; How many columns of text a formula takes when it is drawn.

(require "../../algebra/notation/name.rkt" "../../algebra/notation/tree.rkt")

(provide make-meter)

;; -> (tree -> columns), which looks at each tree once
(define (make-meter)
  (define known (make-hasheq))
  (define (wide t) (hash-ref! known t (lambda () (measure t wide))))
  wide)

(define (total wide ts [gap 0])
  (+ (* gap (max 0 (- (length ts) 1))) (for/sum ([t (in-list ts)]) (wide t))))

(define (widest wide ts) (apply max 0 (map wide ts)))

(define (measure t wide)
  (cond [(name? t) (name-width (name-parts (name-symbol t)))]
        [(word? t) (string-length (word-text t))]
        [(digits? t) (string-length (digits-text t))]
        [(plain? t) (string-length (plain-text t))]
        [(sum? t) (+ (total wide (tree-parts t) 3)
                     (if (term-negative? (car (sum-terms t))) 1 0))]
        [(product? t) (total wide (tree-parts t) 1)]
        [(fraction? t) (+ 2 (widest wide (tree-parts t)))]
        [(application? t)
         (define arguments (total wide (application-arguments t) 2))
         (+ (wide (application-function t)) arguments (if (application-bare? t) 1 2))]
        [(derivative? t) (+ (total wide (tree-parts t)) (marks-width t))]
        [else (measure-other t wide)]))

(define (measure-other t wide)
  (define parts (tree-parts t))
  (cond [(scientific? t) (+ 6 (string-length (scientific-digits t)))]
        [(omitted? t) (string-length (omitted-count t))]
        [(or (column? t) (broken? t)) (+ 2 (widest wide parts))]
        [(or (across? t) (listing? t)) (+ 2 (total wide parts 2))]
        [(grid? t) (+ 2 (grid-width t wide))]
        [(relation? t) (total wide parts 3)]
        [(report? t)
         (define (line-width l)
           (+ (* 2 (report-line-depth l)) (string-length (report-line-label l)) 1
              (total wide (report-line-parts l) 1)))
         (widest line-width (report-lines t))]
        [(or (row? t) (power? t)) (total wide parts)]
        [else (+ 2 (total wide parts))]))

(define (name-width p)
  (+ (string-length (parts-base p))
     (string-length (parts-digits p))
     (for/sum ([m (in-list (parts-marks p))]) (string-length (cdr m)))))

(define (marks-width t)
  (for/sum ([m (in-list (derivative-marks t))])
    (+ 1 (* 2 (length (or (mark-path m) '()))) (if (= 1 (mark-count m)) 0 1))))

(define (grid-width t wide)
  (define columns (apply map list (grid-rows t)))
  (total (lambda (c) (widest wide c)) columns 2))
