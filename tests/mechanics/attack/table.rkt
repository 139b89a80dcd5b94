#lang racket/base
;; The table of an attack: how many claims of each class were answered and judged how.

(require racket/format)

(provide make-table table-add! table-claims table-wrong table-count
         wrong-judgement? told-judgement?
         print-table)

;; (class column) -> count, where a column is an answer, or a judgement as a list
(define (make-table) (make-hash))

(define (note! t . key) (hash-update! t key add1 0))
(define (entry t . key) (hash-ref t key 0))

;; Open is what was to be decided and is not, and what took too long.
(define (told-judgement? j) (and j (not (eq? j 'unjudged))))
(define (wrong-judgement? j) (and j (not (memq j '(unjudged open)))))

;; report : (class k ((answer . judgement) ...) program ...)
(define (table-add! t report)
  (define class (car report))
  (for ([o (in-list (caddr report))])
    (define-values (answer judgement) (values (car o) (cdr o)))
    (note! t 'claims)
    (note! t class 'claims)
    (note! t class answer)
    (when judgement (note! t class (list judgement)))
    (when (wrong-judgement? judgement)
      (note! t 'wrong)
      (note! t class 'wrong))))

(define (table-claims t) (entry t 'claims))
(define (table-wrong t) (entry t 'wrong))

;; How many claims of the class were judged so?
(define (table-count t class judgement) (entry t class (list judgement)))

;; ---------------------------------------------------------------------------

(define columns '(claims proved refuted undecided form found slow rejected unjudged wrong))

(define (print-table t classes)
  (print-row "class" (map ~a columns))
  (for ([class (in-list classes)])
    (print-row (~a class)
               (for/list ([c (in-list columns)])
                 (~a (entry t class (if (eq? c 'unjudged) '(unjudged) c))))))
  (for ([class (in-list classes)] #:when (> (entry t class 'wrong) 0))
    (printf "wrong in ~a: ~a\n" class
            (apply ~a #:separator ", "
                   (for/list ([(key n) (in-hash t)]
                              #:when (and (eq? (car key) class) (pair? (cdr key)) (pair? (cadr key))
                                          (wrong-judgement? (caadr key))))
                     (format "~a ~a" n (caadr key)))))))

(define (print-row name cells)
  (printf "~a~a\n" (~a name #:width 26)
          (apply ~a (map (lambda (c) (~a c #:width 10 #:align 'right)) cells))))
