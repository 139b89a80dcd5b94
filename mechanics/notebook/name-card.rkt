#lang racket/base
;; The answer to (help name) for a front end: the text, and elements of a page in which the
;; results of the example are typeset.

(require (only-in file/convertible convertible?)
         (only-in racket/string string-join string-replace)
         (only-in xml xexpr->string)
         "mime-bundle.rkt"
         (only-in "../lang/help/demonstration.rkt" result-line)
         "../lang/help/help-answer.rkt")

(provide name->bundle)

;; text : as a prompt prints the result; markup : elements as text
(struct typeset (text markup))

(define (name->bundle name)
  (define print (result-line))
  (define lines
    (parameterize ([result-line (lambda (x width) (typeset-result x (print x width) width))])
      (help-lines name)))
  (hasheq (string->symbol "text/plain") (string-join (map line-text lines) "\n")
          (string->symbol "text/html")
          (format "<div class=\"mechanics ~a\">~a</div>" "mathjax_ignore tex2jax_ignore"
                  (lines->markup lines))))

;; Pictures, which take their time, stay text.
(define (typeset-result x text width)
  (define b (if (convertible? x) (hasheq) (value->bundle x '() #:columns width)))
  (define TeX (hash-ref b (string->symbol "text/latex") #f))
  (define markup
    (if TeX
        (xexpr->string `(div ([class "mathjax_process tex2jax_process"]
                              [style "white-space: pre-line; margin: 0.5em 1.5em"])
                             ,TeX))
        (hash-ref b (string->symbol "text/html") #f)))
  (if markup (typeset text markup) text))

(define (line-text l)
  (if (typeset? l) (string-append "  " (string-replace (typeset-text l) "\n" "\n  ")) l))

;; Lines of text that follow each other are one element.
(define (lines->markup lines)
  (define (text->markup texts)
    (if (null? texts) "" (xexpr->string `(pre ,(string-join (reverse texts) "\n")))))
  (let loop ([lines lines] [texts '()])
    (cond [(null? lines) (text->markup texts)]
          [(typeset? (car lines))
           (string-append (text->markup texts) (typeset-markup (car lines))
                          (loop (cdr lines) '()))]
          [else (loop (cdr lines) (cons (car lines) texts))])))
