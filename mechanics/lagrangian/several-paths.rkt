#lang racket/base
;; Paths given one by one, x and y, where one path of all coordinates is wanted: (up x y).

(require "../error/message-words.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt")

(provide one-path-hint check-time-of-path)

;; paths : functions of the time; (call path) : how one is used, by the text of it
(define (one-path-hint paths [call values])
  (format "\n  one path of ~a: ~a" (if (= (length paths) 2) "both" "all")
          (call (format "(up ~a)" (joined (names-of paths) " ")))))

;; Texts of their names; letters, where one of the paths has no name.
(define (names-of paths)
  (define names (map value->datum paths))
  (for/list ([name (in-list names)] [k (in-naturals)])
    (cond [(andmap nameable? names) (symbol->string name)]
          [(< k (length letters)) (list-ref letters k)]
          [else (format "q~a" k)])))

(define letters '("x" "y" "z"))

(define (nameable? d) (and (symbol? d) (not (eq? d '<function>))))

;; t is given where the time of the path q is expected; a second path, or a state, is refused.
(define (check-time-of-path who q t [call values])
  (when (or (pointwise? t) (tuple? t) (pair? t))
    (complain-of-argument who "a time" t
                          (if (and (pointwise? q) (pointwise? t))
                              (one-path-hint (list q t) call)
                              ""))))
